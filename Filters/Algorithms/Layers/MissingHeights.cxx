// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OrderedStack.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// ---- Holes and gaps ------------------------------------------------------------------------------------------------
/// Runs of at most `largest` empty columns between two of a row or column of the lattice.
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
  std::sort(gaps.begin(), gaps.end(), PrecedesByRow);
  gaps.erase(std::unique(gaps.begin(), gaps.end()), gaps.end());
  return gaps;
}

class GapInterpolation
{
public:
  GapInterpolation(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns)
    : Horizon(horizon)
    , Cuts(cuts)
    , Columns(columns)
    , Known(horizon.Columns)
    , Missing(columns)
  {
  }

  /// Lines with heights at both ends count first, then those with one, then those across cuts.
  void Fill(std::vector<double>& heights)
  {
    const auto fill = [&](bool atBothEnds)
    {
      while (this->FillOnce(atBothEnds, heights))
      {
      }
    };
    fill(true);
    fill(false);
    this->Cuts = nullptr;
    fill(false);
  }

private:
  struct LineEnd
  {
    double Height = std::nan("");
    double Distance = 0.0; // in steps
  };

  bool FillOnce(bool atBothEnds, std::vector<double>& heights) const
  {
    std::vector<double> filled = heights;
    std::atomic<bool> isAny = false;
    ParallelFor(std::int64_t(heights.size()), GapGrain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        {
          if (std::isnan(heights[n]))
          {
            filled[n] = this->HeightAt(this->Columns[n], atBothEnds, heights);
            isAny = isAny || !std::isnan(filled[n]);
          }
        }
      });
    heights.swap(filled);
    return isAny;
  }

  double HeightAt(const PlanePoint& column, bool atBothEnds, const std::vector<double>& heights) const
  {
    double sum = 0.0;
    double weights = 0.0;
    const auto add = [&](double height, double distance)
    {
      sum += height / distance;
      weights += 1.0 / distance;
    };
    for (const PlanePoint& step : { PlanePoint{ 1, 0 }, PlanePoint{ 0, 1 }, PlanePoint{ 1, 1 }, PlanePoint{ 1, -1 } })
    {
      const double length = step.X != 0 && step.Y != 0 ? std::sqrt(2.0) : 1.0;
      const LineEnd a = this->FindEnd(column, step, heights);
      const LineEnd b = this->FindEnd(column, { -step.X, -step.Y }, heights);
      const bool areBoth = !std::isnan(a.Height) && !std::isnan(b.Height);
      if (areBoth)
      {
        add((a.Height * b.Distance + b.Height * a.Distance) / (a.Distance + b.Distance),
          length * (a.Distance + b.Distance));
      }
      for (const LineEnd& one : { a, b })
      {
        if (!atBothEnds && !areBoth && !std::isnan(one.Height))
        {
          add(one.Height, length * one.Distance);
        }
      }
    }
    return sum / weights; // nan if there is none
  }

  LineEnd FindEnd(PlanePoint column, const PlanePoint& step, const std::vector<double>& heights) const
  {
    for (int distance = 1; distance <= Farthest && !(this->Cuts && this->Cuts->IsCutBeside(column, step)); ++distance)
    {
      column = { column.X + step.X, column.Y + step.Y };
      const PointId known = this->Known.PointAt(column);
      const PointId missing = known == NoPoint ? this->Missing.PointAt(column) : NoPoint;
      const double height = known != NoPoint ? this->Horizon.Heights[known]
        : missing != NoPoint                 ? heights[std::size_t(missing)]
                                             : std::nan("");
      if (!std::isnan(height))
      {
        return { height, double(distance) };
      }
    }
    return {};
  }

  static constexpr int Farthest = 256; // columns
  static constexpr std::int64_t GapGrain = 1024; // columns that a thread takes at a time

  const HorizonView& Horizon;
  const LinkCuts* Cuts;
  PlanePoints Columns;
  const ColumnIndex Known;
  const ColumnIndex Missing;
};

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
  for (int pass = 0; pass < 2; ++pass) // the second pass is for sparse lines in both directions
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
/// Finds the areas in which a horizon is absent between others, and which of these it follows.
class Follower
{
public:
  Follower(PlanePoints columns, const HeightStack& heights, OriginStack& origins)
    : Columns(columns)
    , Index(columns)
    , Heights(heights)
    , Origins(origins)
  {
  }

  void Run(std::size_t horizon)
  {
    std::vector<unsigned char> isAbsent(this->Columns.size());
    for (std::size_t column = 0; column < isAbsent.size(); ++column)
    {
      isAbsent[column] = std::isnan(this->Heights[horizon][column]) && !std::isnan(this->Next(horizon, column, -1)) &&
          !std::isnan(this->Next(horizon, column, 1))
        ? 1
        : 0;
    }
    DisjointSets areas(isAbsent.size());
    this->ForEachNeighbour(isAbsent,
      [&](std::size_t column, std::size_t neighbour)
      {
        if (isAbsent[neighbour] != 0)
        {
          areas.Join(std::int32_t(column), std::int32_t(neighbour));
        }
      });
    std::map<std::int32_t, Shares> borders; // by area
    this->ForEachNeighbour(isAbsent,
      [&](std::size_t column, std::size_t neighbour)
      { this->AddShare(horizon, neighbour, borders[areas.Find(std::int32_t(column))]); });
    for (std::size_t column = 0; column < isAbsent.size(); ++column)
    {
      if (isAbsent[column] != 0)
      {
        const Shares& border = borders[areas.Find(std::int32_t(column))];
        this->Origins[horizon][column] =
          border.Sum < 0.5 * border.Count ? HeightOrigin::FollowsAbove : HeightOrigin::FollowsBelow;
      }
    }
  }

private:
  /// How far down, from 0 to 1, the horizon is between its neighbours along the border of an area.
  struct Shares
  {
    double Sum = 0.0;
    double Count = 0.0;
  };

  template <typename Visit>
  void ForEachNeighbour(const std::vector<unsigned char>& marks, Visit&& visit) const
  {
    for (std::size_t n = 0; n < marks.size(); ++n)
    {
      for (const PlanePoint& step : { PlanePoint{ 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } })
      {
        const PlanePoint& column = this->Columns[n];
        const PointId neighbour =
          marks[n] != 0 ? this->Index.PointAt({ column.X + step.X, column.Y + step.Y }) : NoPoint;
        if (neighbour != NoPoint)
        {
          visit(n, std::size_t(neighbour));
        }
      }
    }
  }

  /// The height of the next horizon upwards (-1) or downwards (1) that has one, or nan.
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

  void AddShare(std::size_t horizon, std::size_t column, Shares& border) const
  {
    const double above = this->Next(horizon, column, -1);
    const double below = this->Next(horizon, column, 1);
    const double share = (above - this->Heights[horizon][column]) / (above - below);
    if (std::isfinite(share))
    {
      border.Sum += std::clamp(share, 0.0, 1.0);
      ++border.Count;
    }
  }

  PlanePoints Columns;
  const ColumnIndex Index;
  const HeightStack& Heights;
  OriginStack& Origins;
};

// ---- Order ---------------------------------------------------------------------------------------------------------
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
  constexpr std::array origins = { HeightOrigin::Known, HeightOrigin::FilledBefore, HeightOrigin::ExtrapolatedBefore };
  return origins[horizon.IsFilled ? horizon.IsFilled[point] : 0];
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
void FillGaps(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns, std::vector<double>& heights)
{
  assert(heights.size() == columns.size());
  GapInterpolation(horizon, cuts, columns).Fill(heights);
}

//----------------------------------------------------------------------------------------------------------------------
OriginStack OriginsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, HeightOrigin ofOthers)
{
  assert(columns.Points.size() == horizons.size());
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
  Follower follower(columns.Columns, heights, origins);
  for (std::size_t n = 1; n + 1 < horizons.size(); ++n)
  {
    if (std::find(origins[n].begin(), origins[n].end(), HeightOrigin::None) != origins[n].end())
    {
      follower.Run(n);
    }
  }
  return origins;
}

//----------------------------------------------------------------------------------------------------------------------
void PutMissing(
  const OriginStack& origins, const HeightStack& given, const CrossingOptions& options, HeightStack& heights)
{
  assert(origins.size() == heights.size() && given.size() == heights.size());
  assert(heights.empty() || (HaveAll(heights, heights.front().size()) && HaveAll(given, heights.front().size())));
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
