// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Thresholds of a simplification of the inside that leave a given number of points (thesis 6.2):
//
//  rough       smallest cell size that does not exceed the number
//  elaborate   flatness threshold by bisection, to 3 % of the number; with larger cells if the largest threshold
//              leaves more, and with smaller cells if 0 leaves fewer
//
// Boundary points are always kept.

#include "CellSimplification.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double AllFlat = 1.0 / 3.0;
constexpr double Enough = 0.97; // A result with at least this fraction of the requested points is accepted.
constexpr int MostTargetHalvings = 12;
// This fraction of the remaining progress is assigned to each run, as the number of runs is unknown.
constexpr double FractionOfRest = 0.15;

/// The result does not change once a cell contains the whole horizon.
int LargestCell(const BoundedHorizon& horizon)
{
  constexpr std::int64_t Largest = 1 << 28;
  if (horizon.Height.empty())
  {
    return 1;
  }
  const PlaneBox box = horizon.Places().Box();
  const auto heights = std::minmax_element(horizon.Height.begin(), horizon.Height.end());
  const std::int64_t side =
    std::max(std::int64_t(box.Greatest.X) - box.Least.X, std::int64_t(box.Greatest.Y) - box.Least.Y);
  const double height = *heights.second - *heights.first;
  const std::int64_t inPlan = side / horizon.SubVoxelsPerColumn + 1;
  return int(std::min({ Largest, std::max(inPlan, std::int64_t(std::min(height, double(Largest)))) + 1, Largest }));
}

template <typename Options, typename Simplify>
class TargetSearch
{
public:
  TargetSearch(std::size_t most, Options& options, const Monitor& monitor, Simplify simplify)
    : Most(most)
    , Given(options)
    , Watch(monitor)
    , Run(std::move(simplify))
  {
  }

  bool Try(const Options& options)
  {
    const double next = this->Part + FractionOfRest * (1.0 - this->Part);
    Reduction reduction = this->Run(options, this->Watch.Step(this->Part, next));
    this->Part = next;
    this->Left = reduction.Source.size();
    if (this->Left > this->Most)
    {
      return false;
    }
    if (this->Left >= this->Found.Source.size())
    {
      this->Found = std::move(reduction);
      this->Given = options;
    }
    return true;
  }

  bool IsNear() const { return double(this->Found.Source.size()) >= Enough * double(this->Most); }

  [[noreturn]] void Refuse() const
  {
    throw InputError("maximum number of points " + std::to_string(this->Most) + ", expected at least the " +
      std::to_string(this->Left) + " that are left with the largest cells: outlines are kept");
  }

  Reduction Take() { return std::move(this->Found); }

private:
  const std::size_t Most;
  Options& Given;
  const Monitor& Watch;
  Simplify Run;
  double Part = 0.0;
  std::size_t Left = 0;
  Reduction Found;
};

template <typename Search, typename Options>
int FindSmallest(Search& search, Options tried, int tooSmall)
{
  int enough = tried.CellSize;
  while (enough - tooSmall > 1)
  {
    tried.CellSize = tooSmall + (enough - tooSmall) / 2;
    (search.Try(tried) ? enough : tooSmall) = tried.CellSize;
  }
  return enough;
}
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyRoughTo(std::size_t most, const BoundedHorizon& horizon, CellOptions& options, const Monitor& monitor)
{
  const int largest = LargestCell(horizon);
  TargetSearch search(most, options, monitor,
    [&](const CellOptions& tried, const Monitor& step) { return SimplifyRough(horizon, tried, step); });
  CellOptions tried = options;
  int tooSmall = 0;
  for (tried.CellSize = 1; !search.Try(tried); tried.CellSize = int(std::min<std::int64_t>(largest, 2LL * tooSmall)))
  {
    tooSmall = tried.CellSize;
    if (tooSmall >= largest)
    {
      search.Refuse();
    }
  }
  FindSmallest(search, tried, tooSmall);
  return search.Take();
}

//----------------------------------------------------------------------------------------------------------------------
Reduction SimplifyElaborateTo(
  std::size_t most, const BoundedHorizon& horizon, ElaborateOptions& options, const Monitor& monitor)
{
  const int largest = LargestCell(horizon);
  TargetSearch search(most, options, monitor,
    [&](const ElaborateOptions& tried, const Monitor& step) { return SimplifyElaborate(horizon, tried, step); });
  ElaborateOptions tried = options;
  // With the largest threshold, the given cell size, or else the smallest one with few enough points, is used.
  tried.FlatnessThreshold = AllFlat;
  int tooSmall = tried.CellSize;
  if (!search.Try(tried))
  {
    do
    {
      tooSmall = tried.CellSize;
      if (tooSmall >= largest)
      {
        search.Refuse();
      }
      tried.CellSize = int(std::min<std::int64_t>(largest, 2LL * tooSmall));
    } while (!search.Try(tried));
    tried.CellSize = FindSmallest(search, tried, tooSmall);
  }
  // With a threshold of 0 and too few points, cells can be smaller.
  tried.FlatnessThreshold = 0.0;
  if (search.Try(tried) && !search.IsNear())
  {
    tried.CellSize = FindSmallest(search, tried, 0);
    --tried.CellSize; // This size has too many points for a threshold of 0.
  }
  if (tried.CellSize < 1)
  {
    return search.Take();
  }
  double tooMany = 0.0;
  double enough = AllFlat;
  for (int n = 0; n < MostTargetHalvings && !search.IsNear(); ++n)
  {
    tried.FlatnessThreshold = 0.5 * (tooMany + enough);
    (search.Try(tried) ? enough : tooMany) = tried.FlatnessThreshold;
  }
  return search.Take();
}
}
