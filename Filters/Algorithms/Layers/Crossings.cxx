// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t ColumnsOfChunk = 1 << 14;

/// Successive horizons of a column that share a height.
struct Pool
{
  double Depth = 0.0;
  int Weight = 0; // exponent of an infinite weight
  double Sum = 0.0; // of the depths of the horizons of the largest weight
  int Count = 0; // of these
  int Size = 0; // of all horizons

  void Take(const Pool& below)
  {
    if (below.Weight > this->Weight)
    {
      this->Weight = below.Weight;
      this->Sum = below.Sum;
      this->Count = below.Count;
      this->Depth = below.Depth;
    }
    else if (below.Weight == this->Weight)
    {
      this->Sum += below.Sum;
      this->Count += below.Count;
      this->Depth = this->Sum / this->Count;
    }
    this->Size += below.Size;
  }
};

/// Adds the next pool downwards, and merges pools as long as the last two overlap.
template <typename Overlap>
void Push(std::vector<Pool>& pools, const Pool& next, Overlap&& overlap)
{
  pools.push_back(next);
  while (pools.size() > 1 && overlap(pools[pools.size() - 2], pools.back()))
  {
    const Pool below = pools.back();
    pools.pop_back();
    pools.back().Take(below);
  }
}

std::vector<CrossingPolicy> PolicyOfEach(const CrossingOptions& options, std::size_t horizons)
{
  if (horizons < 2)
  {
    throw InputError((horizons == 1 ? "one horizon" : "no horizon") + std::string(", expected at least 2"));
  }
  if (options.Policies.size() == 1)
  {
    return std::vector<CrossingPolicy>(horizons - 1, options.Policies.front());
  }
  if (options.Policies.size() != horizons - 1)
  {
    throw InputError(std::to_string(options.Policies.size()) + " policies of crossings, expected one, or " +
      std::to_string(horizons - 1) + " for " + std::to_string(horizons) + " horizons");
  }
  return options.Policies;
}

std::vector<int> WeightOfEach(const std::vector<CrossingPolicy>& policies)
{
  std::vector<int> weights = { 0 };
  for (const CrossingPolicy policy : policies)
  {
    const int step = policy == CrossingPolicy::UpperWins ? -1 : policy == CrossingPolicy::LowerWins ? 1 : 0;
    weights.push_back(weights.back() + step);
  }
  return weights;
}

class ColumnRepair
{
public:
  ColumnRepair(
    HeightStack& heights, const std::vector<int>& weights, const CrossingOptions& options, CrossingRepair& sums)
    : Heights(heights)
    , Weights(weights)
    , Minimum(options.MinimumThickness)
    , Sign(options.HeightsGrowDownwards ? 1.0 : -1.0)
    , Sums(sums)
  {
    sums.Interfaces.resize(heights.size() - 1);
    sums.Horizons.resize(heights.size());
  }

  void Repair(std::size_t column)
  {
    if (this->IsInOrder(column))
    {
      return;
    }
    this->CountCrossings(column);
    this->Pools.clear();
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      const double depth = this->Depth(horizon, column);
      if (std::isnan(depth))
      {
        continue;
      }
      Push(this->Pools, { depth, this->Weights[horizon], depth, 1, 1 },
        [this](const Pool& above, const Pool& below) { return this->Overlap(above.Depth, below.Depth); });
    }
    std::size_t horizon = 0;
    for (const Pool& pool : this->Pools)
    {
      for (int n = 0; n < pool.Size; ++n)
      {
        while (std::isnan(this->Heights[horizon][column]))
        {
          ++horizon;
        }
        this->Move(horizon++, column, this->Sign * pool.Depth);
      }
    }
  }

private:
  /// Most columns are, so that they need no pools.
  bool IsInOrder(std::size_t column) const
  {
    double above = -std::numeric_limits<double>::infinity();
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      const double depth = this->Depth(horizon, column);
      if (this->Overlap(above, depth)) // false for nan
      {
        return false;
      }
      above = std::isnan(depth) ? above : depth;
    }
    return true;
  }

  double Depth(std::size_t horizon, std::size_t column) const { return this->Sign * this->Heights[horizon][column]; }

  bool Overlap(double above, double below) const
  {
    const double between = below - above;
    return between < 0.0 || (between > 0.0 && between < this->Minimum);
  }

  void CountCrossings(std::size_t column)
  {
    for (std::size_t n = 0; n + 1 < this->Heights.size(); ++n)
    {
      const double above = this->Depth(n, column) - this->Depth(n + 1, column);
      if (above > 0.0)
      {
        this->Sums.Interfaces[n].Add({ 1, above });
      }
    }
  }

  void Move(std::size_t horizon, std::size_t column, double height)
  {
    double& old = this->Heights[horizon][column];
    if (height != old)
    {
      this->Sums.Horizons[horizon].Add({ 1, std::abs(height - old) });
      old = height;
    }
  }

  HeightStack& Heights;
  const std::vector<int>& Weights;
  const double Minimum;
  const double Sign;
  CrossingRepair& Sums;
  std::vector<Pool> Pools;
};

void StopWhereAsked(
  const std::vector<CrossingPolicy>& policies, const CrossingOptions& options, const CrossingRepair& repair)
{
  for (std::size_t n = 0; n < policies.size(); ++n)
  {
    if (policies[n] == CrossingPolicy::Stop && repair.Interfaces[n].Columns > 0)
    {
      std::ostringstream message;
      message << NameOf(n, options) << " and " << NameOf(n + 1, options) << " cross in " << repair.Interfaces[n].Columns
              << (repair.Interfaces[n].Columns == 1 ? " column" : " columns") << ", by up to "
              << repair.Interfaces[n].Largest << ' ' << options.Unit
              << ", expected none: choose Mean, UpperWins or LowerWins";
      throw InputError(message.str());
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameOf(std::size_t horizon, const CrossingOptions& options)
{
  return horizon < options.Names.size() ? options.Names[horizon] : "horizon " + std::to_string(horizon + 1);
}

//----------------------------------------------------------------------------------------------------------------------
void CrossingRepair::Add(const CrossingRepair& other)
{
  const auto add = [](std::vector<RepairFigures>& sums, const std::vector<RepairFigures>& more)
  {
    sums.resize(std::max(sums.size(), more.size()));
    for (std::size_t n = 0; n < more.size(); ++n)
    {
      sums[n].Add(more[n]);
    }
  };
  add(this->Interfaces, other.Interfaces);
  add(this->Horizons, other.Horizons);
}

//----------------------------------------------------------------------------------------------------------------------
CrossingRepair RepairCrossings(HeightStack& heights, const CrossingOptions& options, const Monitor& monitor)
{
  const std::vector<CrossingPolicy> policies = PolicyOfEach(options, heights.size());
  CheckAtLeast("minimum thickness", options.MinimumThickness, 0.0, " lattice units");
  const std::vector<int> weights = WeightOfEach(policies);
  const auto columns = std::int64_t(heights.front().size());
  assert(HaveAll(heights, heights.front().size()));
  CrossingRepair sums = AddUpChunks<CrossingRepair>(columns, ColumnsOfChunk, monitor,
    [&](CrossingRepair& part, std::int64_t first, std::int64_t last)
    {
      ColumnRepair repair(heights, weights, options, part);
      for (std::int64_t column = first; column < last; ++column)
      {
        repair.Repair(std::size_t(column));
      }
    });
  sums.Interfaces.resize(policies.size()); // where there is no column
  sums.Horizons.resize(heights.size());
  StopWhereAsked(policies, options, sums);
  return sums;
}

//----------------------------------------------------------------------------------------------------------------------
void OrderColumn(
  std::vector<double>& heights, const std::vector<unsigned char>& isOneWithNext, bool heightsGrowDownwards)
{
  assert(isOneWithNext.size() + 1 >= heights.size());
  const double sign = heightsGrowDownwards ? 1.0 : -1.0;
  std::vector<Pool> pools;
  for (std::size_t horizon = 0; horizon < heights.size();)
  {
    Pool group;
    bool goesOn = true;
    for (; goesOn; ++horizon)
    {
      const double depth = sign * heights[horizon];
      group.Take({ depth, 0, depth, 1, 1 });
      goesOn = horizon + 1 < heights.size() && isOneWithNext[horizon] != 0;
    }
    Push(pools, group, [](const Pool& above, const Pool& below) { return below.Depth < above.Depth; });
  }
  std::size_t horizon = 0;
  for (const Pool& pool : pools)
  {
    for (int n = 0; n < pool.Size; ++n)
    {
      heights[horizon++] = sign * pool.Depth;
    }
  }
}
}
