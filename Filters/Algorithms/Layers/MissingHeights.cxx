// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MissingHeights.h"

#include "Common/ColumnIndex.h"
#include "Common/DisjointSets.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"
#include "GapHeights.h"
#include "HoleFilling/HoleFilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 1 << 14; // columns that a thread takes at a time

// ---- Holes and gaps ------------------------------------------------------------------------------------------------
/// Empty columns between two of a row, or of a column, of the lattice that have at most `largest` of them between them.
std::vector<PlanePoint> FindGaps(PlanePoints columns, int largest)
{
  const ColumnIndex index(columns);
  std::vector<PlanePoint> gaps;
  for (const PlanePoint& column : columns)
  {
    for (const PlanePoint& step : { PlanePoint{ 1, 0 }, PlanePoint{ 0, 1 } })
    {
      const auto at = [&](int n) { return PlanePoint{ column.X + n * step.X, column.Y + n * step.Y }; };
      int end = 1;
      for (; end <= largest + 1 && index.PointAt(at(end)) == NoPoint; ++end)
      {
      }
      for (int n = 1; n < end && end <= largest + 1; ++n)
      {
        gaps.push_back(at(n));
      }
    }
  }
  std::sort(gaps.begin(), gaps.end(),
    [](const PlanePoint& a, const PlanePoint& b) { return std::tie(a.Y, a.X) < std::tie(b.Y, b.X); });
  gaps.erase(std::unique(gaps.begin(), gaps.end()), gaps.end());
  return gaps;
}

void FillHorizon(const HorizonView& horizon, const MissingOptions& options, const LinkCuts* cuts,
  std::vector<PlanePoint>& columns, std::vector<double>& heights, const Monitor& monitor)
{
  columns.assign(horizon.Columns.begin(), horizon.Columns.end());
  heights.assign(horizon.Heights, horizon.Heights + columns.size());
  const auto add = [&](const std::vector<PlanePoint>& newColumns, const std::vector<double>& newHeights)
  {
    columns.insert(columns.end(), newColumns.begin(), newColumns.end());
    heights.insert(heights.end(), newHeights.begin(), newHeights.end());
  };
  if (options.LargestHole > 0)
  {
    HoleFillingOptions holes;
    holes.LargestHoleSize = options.LargestHole;
    const FilledColumns filled = FillHoles(horizon.Columns, heights, {}, holes, cuts, monitor);
    add(filled.Column, filled.Height);
  }
  // Gaps along rows and columns; then those between columns that were found: of sparse lines, what is between both.
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::vector<PlanePoint> gaps = FindGaps(columns, options.LargestGap);
    if (!gaps.empty())
    {
      std::vector<double> found(gaps.size(), std::nan(""));
      FillGaps({ columns, heights.data() }, cuts, gaps, found);
      add(gaps, found);
    }
  }
}

// ---- Following others ----------------------------------------------------------------------------------------------
/// The areas in which one horizon is absent between others, and which of these it follows.
class Follower
{
public:
  Follower(const CommonColumns& columns, const ColumnIndex& index, const HeightStack& heights, OriginStack& origins)
    : Columns(columns)
    , Index(index)
    , Heights(heights)
    , Origins(origins)
  {
  }

  void Run(std::size_t horizon)
  {
    std::vector<std::size_t> absent;
    this->NumberOf.assign(this->Columns.Columns.size(), NotAbsent);
    for (std::size_t column = 0; column < this->Columns.Columns.size(); ++column)
    {
      if (std::isnan(this->Heights[horizon][column]) && this->IsBetween(horizon, column))
      {
        this->NumberOf[column] = std::int32_t(absent.size());
        absent.push_back(column);
      }
    }
    DisjointSets areas(absent.size());
    std::vector<Share> shares(absent.size());
    const std::array<PlanePoint, 4> steps = { { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } } };
    for (std::size_t n = 0; n < absent.size(); ++n)
    {
      for (const PlanePoint& step : steps)
      {
        const PlanePoint& column = this->Columns.Columns[absent[n]];
        const PointId other = this->Index.PointAt({ column.X + step.X, column.Y + step.Y });
        const std::int32_t number = other == NoPoint ? NotAbsent : this->NumberOf[std::size_t(other)];
        if (number != NotAbsent)
        {
          areas.Join(std::int32_t(n), number);
        }
        else if (other != NoPoint && !std::isnan(this->Heights[horizon][std::size_t(other)]))
        {
          shares[n].Add(this->ShareAt(horizon, std::size_t(other)));
        }
      }
    }
    std::vector<Share> ofAreas(absent.size());
    for (std::size_t n = 0; n < absent.size(); ++n)
    {
      ofAreas[std::size_t(areas.Find(std::int32_t(n)))].Add(shares[n]);
    }
    for (std::size_t n = 0; n < absent.size(); ++n)
    {
      const Share& share = ofAreas[std::size_t(areas.Find(std::int32_t(n)))];
      this->Origins[horizon][absent[n]] =
        share.Sum < 0.5 * share.Count ? HeightOrigin::FollowsAbove : HeightOrigin::FollowsBelow;
    }
  }

private:
  static constexpr std::int32_t NotAbsent = -1;

  /// How far down a horizon is between its neighbours: 0 at the upper one.
  struct Share
  {
    double Sum = 0.0;
    double Count = 0.0;

    void Add(const Share& other)
    {
      this->Sum += other.Sum;
      this->Count += other.Count;
    }
  };

  /// The height of the next horizon that is there, upwards (-1) or downwards; nan where there is none.
  double Next(std::size_t horizon, std::size_t column, int step) const
  {
    for (auto n = std::ptrdiff_t(horizon) + step; n >= 0 && n < std::ptrdiff_t(this->Heights.size()); n += step)
    {
      if (!std::isnan(this->Heights[std::size_t(n)][column]))
      {
        return this->Heights[std::size_t(n)][column];
      }
    }
    return std::nan("");
  }

  bool IsBetween(std::size_t horizon, std::size_t column) const
  {
    return !std::isnan(this->Next(horizon, column, -1)) && !std::isnan(this->Next(horizon, column, 1));
  }

  Share ShareAt(std::size_t horizon, std::size_t column) const
  {
    const double above = this->Next(horizon, column, -1);
    const double below = this->Next(horizon, column, 1);
    const double share = (above - this->Heights[horizon][column]) / (above - below);
    return std::isfinite(share) ? Share{ std::clamp(share, 0.0, 1.0), 1.0 } : Share();
  }

  const CommonColumns& Columns;
  const ColumnIndex& Index;
  const HeightStack& Heights;
  OriginStack& Origins;
  std::vector<std::int32_t> NumberOf; // of columns, among the absent ones
};

// ---- Order ---------------------------------------------------------------------------------------------------------
/// Puts the heights of one column in.
class ColumnCompleter
{
public:
  ColumnCompleter(
    const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights)
    : Origins(origins)
    , Given(given)
    , Heights(heights)
    , Upwards(options.HeightsGrowDownwards ? -1.0 : 1.0)
    , Minimum(options.MinimumThickness)
  {
  }

  void Complete(std::size_t column)
  {
    double above = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < this->Heights.size(); ++n)
    {
      const HeightOrigin origin = this->Origins[n][column];
      if (origin == HeightOrigin::Filled || origin == HeightOrigin::Bridged)
      {
        const double below = this->Below(n, column, IsRead);
        this->Set(n, column, this->Between(above, this->Upwards * this->Given[n][column], below));
      }
      above = this->IsSettled(origin) ? this->Upwards * this->Heights[n][column] : above;
    }
    for (std::size_t n = 0; n < this->Heights.size(); ++n)
    {
      const HeightOrigin origin = this->Origins[n][column];
      if (origin == HeightOrigin::FollowsAbove)
      {
        this->Set(n, column, above);
      }
      else if (origin == HeightOrigin::FollowsBelow)
      {
        this->Set(n, column, this->Below(n, column, this->IsSettled));
      }
      above = origin == HeightOrigin::None ? above : this->Upwards * this->Heights[n][column];
    }
  }

private:
  static bool IsSettled(HeightOrigin origin) { return origin != HeightOrigin::None && !Follows(origin); }

  void Set(std::size_t horizon, std::size_t column, double height)
  {
    this->Heights[horizon][column] = this->Upwards * height;
  }

  /// The height of the next horizon downwards of some origins.
  template <typename IsOne>
  double Below(std::size_t horizon, std::size_t column, IsOne&& isOne) const
  {
    for (std::size_t n = horizon + 1; n < this->Heights.size(); ++n)
    {
      if (isOne(this->Origins[n][column]))
      {
        return this->Upwards * this->Heights[n][column];
      }
    }
    return -std::numeric_limits<double>::infinity();
  }

  double Between(double above, double height, double below) const
  {
    const double between = std::min(std::max(height, below), above);
    return above - between < this->Minimum ? above : between - below < this->Minimum ? below : between;
  }

  const OriginStack& Origins;
  const HeightStack& Given;
  HeightStack& Heights;
  const double Upwards;
  const double Minimum;
};
}

//----------------------------------------------------------------------------------------------------------------------
HeightOrigin ReadOrigin(const HorizonView& horizon, PointId point)
{
  const int filled = horizon.IsFilled ? horizon.IsFilled[point] : 0;
  return filled == 0 ? HeightOrigin::Known
    : filled == 1    ? HeightOrigin::FilledBefore
                     : HeightOrigin::ExtrapolatedBefore;
}

//----------------------------------------------------------------------------------------------------------------------
bool Follows(HeightOrigin origin)
{
  return origin == HeightOrigin::FollowsAbove || origin == HeightOrigin::FollowsBelow;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsRead(HeightOrigin origin)
{
  return origin == HeightOrigin::Known || origin == HeightOrigin::FilledBefore ||
    origin == HeightOrigin::ExtrapolatedBefore;
}

//----------------------------------------------------------------------------------------------------------------------
bool AreAllRead(const OriginStack& origins)
{
  return std::all_of(origins.begin(), origins.end(),
    [](const std::vector<HeightOrigin>& own) { return std::all_of(own.begin(), own.end(), IsRead); });
}

//----------------------------------------------------------------------------------------------------------------------
bool Allows(MissingPolicy policy, HeightOrigin origin)
{
  return IsRead(origin) || (origin == HeightOrigin::Filled && policy != MissingPolicy::Void) ||
    (Follows(origin) && policy == MissingPolicy::Follow);
}

//----------------------------------------------------------------------------------------------------------------------
FilledHorizons FillHorizons(
  const std::vector<HorizonView>& horizons, const MissingOptions& options, const LinkCuts* cuts, const Monitor& monitor)
{
  CheckAtLeast<std::int64_t>("largest hole", options.LargestHole, 0, " columns");
  CheckWithin("largest gap", options.LargestGap, 0, 255, " columns");
  FilledHorizons filled;
  filled.Views = horizons;
  filled.Columns.resize(horizons.size());
  filled.Heights.resize(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    const PlaneBox box(horizons[n].Columns);
    const double size =
      horizons[n].Columns.empty() ? 0.0 : (1.0 + box.Greatest.X - box.Least.X) * (1.0 + box.Greatest.Y - box.Least.Y);
    if (size == double(horizons[n].Columns.size()))
    {
      continue; // nothing is missing
    }
    const auto part = double(n) / double(horizons.size());
    std::vector<PlanePoint>& columns = filled.Columns[n];
    FillHorizon(
      horizons[n], options, cuts, columns, filled.Heights[n], monitor.Step(part, part + 1.0 / double(horizons.size())));
    if (columns.size() > horizons[n].Columns.size())
    {
      filled.Views[n] = { columns, filled.Heights[n].data(), horizons[n].Columns.size(), horizons[n].IsFilled };
      continue;
    }
    columns = {};
    filled.Heights[n] = {};
  }
  return filled;
}

//----------------------------------------------------------------------------------------------------------------------
OriginStack OriginsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, HeightOrigin ofOthers)
{
  OriginStack origins(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    origins[n].resize(columns.Columns.size());
    std::transform(columns.Points[n].begin(), columns.Points[n].end(), origins[n].begin(),
      [&](PointId point)
      {
        const HeightOrigin ofNew = point == NoPoint ? ofOthers : HeightOrigin::Filled;
        return horizons[n].Knows(point) ? ReadOrigin(horizons[n], point) : ofNew;
      });
  }
  return origins;
}

//----------------------------------------------------------------------------------------------------------------------
OriginStack FindOrigins(
  const std::vector<HorizonView>& horizons, const CommonColumns& columns, const HeightStack& heights)
{
  OriginStack origins = OriginsOf(horizons, columns, HeightOrigin::None);
  const ColumnIndex index(columns.Columns);
  for (std::size_t n = 1; n + 1 < horizons.size(); ++n)
  {
    if (std::find(origins[n].begin(), origins[n].end(), HeightOrigin::None) != origins[n].end())
    {
      Follower(columns, index, heights, origins).Run(n);
    }
  }
  return origins;
}

//----------------------------------------------------------------------------------------------------------------------
void PutMissing(
  const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights)
{
  ParallelFor(heights.empty() ? 0 : std::int64_t(heights.front().size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      ColumnCompleter completer(origins, given, options, heights);
      for (auto column = std::size_t(first); column < std::size_t(last); ++column)
      {
        completer.Complete(column);
      }
    });
}
}
