// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OrderedStack.h"

#include "Common/ColumnIndex.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "Common/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 1 << 14; // columns that a thread takes at a time

void CheckHorizons(const std::vector<HorizonView>& horizons, const CrossingOptions& names)
{
  if (horizons.size() < 2)
  {
    throw InputError((horizons.empty() ? "no horizon" : "one horizon") + std::string(", expected at least 2"));
  }
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    const double* const heights = horizons[n].Heights;
    ParallelFor(std::int64_t(horizons[n].Columns.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        const double* const wrong =
          std::find_if(heights + first, heights + last, [](double height) { return !std::isfinite(height); });
        if (wrong != heights + last)
        {
          throw InputError(NameOf(n, names) + ": point " + std::to_string(wrong - heights) +
            " without a height, expected a finite number");
        }
      });
  }
}

/// Why horizons have no column in common: for two of them, where there are such.
InputError NothingInCommon(const std::vector<HorizonView>& horizons, const CrossingOptions& names)
{
  for (std::size_t a = 0; a < horizons.size(); ++a)
  {
    for (std::size_t b = a + 1; b < horizons.size(); ++b)
    {
      if (FindCommonColumns({ horizons[a], horizons[b] }).Columns.empty())
      {
        return InputError(NameOf(a, names) + " and " + NameOf(b, names) +
          " have no column in common, expected horizons that lie above each other");
      }
    }
  }
  return InputError("no column that all " + std::to_string(horizons.size()) +
    " horizons have, expected horizons that lie above each other");
}

/// By horizon; nan where one has no point.
HeightStack HeightsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns)
{
  HeightStack stack;
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    std::vector<double> heights(columns.Points[n].size());
    ParallelFor(std::int64_t(heights.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        std::transform(columns.Points[n].begin() + first, columns.Points[n].begin() + last, heights.begin() + first,
          [&](PointId point) { return point == NoPoint ? std::nan("") : horizons[n].Heights[point]; });
      });
    stack.push_back(std::move(heights));
  }
  return stack;
}

// ---- Gaps ----------------------------------------------------------------------------------------------------------
/// Which columns are inside loops or on them.
class LoopRows
{
public:
  LoopRows(PlanePoints columns, const Loops& loops)
  {
    for (std::size_t loop = 0; loop < loops.Size(); ++loop)
    {
      const PointId* const points = loops.begin(loop);
      for (std::size_t n = 0; n < loops.Length(loop); ++n)
      {
        this->AddEdge(columns, points[n], points[(n + 1) % loops.Length(loop)]);
      }
    }
    std::sort(this->On.begin(), this->On.end());
    std::sort(this->Crossings.begin(), this->Crossings.end());
  }

  /// A point of a loop that a column is on, or NoPoint.
  PointId LoopAt(const PlanePoint& column) const
  {
    const auto found = std::lower_bound(this->On.begin(), this->On.end(), Place{ column, 0 });
    return found != this->On.end() && found->Column == column ? found->Point : NoPoint;
  }

  /// One of the loop to the left of a column inside, or NoPoint for one outside.
  PointId LoopAround(const PlanePoint& column) const
  {
    const auto isLeft = [](const Crossing& crossing, const PlanePoint& place)
    { return std::pair(crossing.Y, crossing.X) < std::pair(place.Y, double(place.X)); };
    const auto isBefore = [](const Crossing& crossing, std::int32_t y) { return crossing.Y < y; };
    const auto first = std::lower_bound(this->Crossings.begin(), this->Crossings.end(), column.Y, isBefore);
    const auto last = std::lower_bound(first, this->Crossings.end(), column, isLeft);
    return (last - first) % 2 == 1 ? std::prev(last)->Point : NoPoint;
  }

private:
  struct Crossing
  {
    std::int32_t Y;
    double X;
    PointId Point; // of the loop

    friend bool operator<(const Crossing& a, const Crossing& b)
    {
      return std::tie(a.Y, a.X, a.Point) < std::tie(b.Y, b.X, b.Point);
    }
  };

  struct Place
  {
    PlanePoint Column;
    PointId Point; // of the loop

    friend bool operator<(const Place& a, const Place& b)
    {
      return std::tie(a.Column.Y, a.Column.X, a.Point) < std::tie(b.Column.Y, b.Column.X, b.Point);
    }
  };

  void AddEdge(PlanePoints columns, PointId from, PointId to)
  {
    const bool isUp = columns[std::size_t(from)].Y <= columns[std::size_t(to)].Y;
    const PlanePoint& a = columns[std::size_t(isUp ? from : to)];
    const PlanePoint& b = columns[std::size_t(isUp ? to : from)];
    this->On.push_back({ a, from });
    this->On.push_back({ b, from });
    ForEachColumnBetween(a, b, [&](const PlanePoint& column, double) { this->On.push_back({ column, from }); });
    for (std::int32_t y = a.Y; y < b.Y; ++y) // without the upper end
    {
      this->Crossings.push_back({ y, a.X + double(y - a.Y) * (b.X - a.X) / (b.Y - a.Y), from });
    }
  }

  std::vector<Place> On;
  std::vector<Crossing> Crossings;
};

/// Those for which keep(n) is true.
template <typename Keep>
void KeepColumns(CommonColumns& columns, Keep&& keep)
{
  std::size_t kept = 0;
  for (std::size_t n = 0; n < columns.Columns.size(); ++n)
  {
    if (keep(n))
    {
      columns.Columns[kept] = columns.Columns[n];
      for (std::vector<PointId>& points : columns.Points)
      {
        points[kept] = points[n];
      }
      ++kept;
    }
  }
  columns.Columns.resize(kept);
  for (std::vector<PointId>& points : columns.Points)
  {
    points.resize(kept);
  }
}

/// The heights of a horizon in gaps: along lines through a column, between the nearest columns with a height, so that
/// planes go on. What was found is used for what has none yet, and where only one side has a height, that is taken.
class GapHeights
{
public:
  GapHeights(const HorizonView& horizon, const LinkCuts* cuts, const std::vector<PlanePoint>& columns)
    : Horizon(horizon)
    , Cuts(cuts)
    , Columns(columns)
    , Known(horizon.Columns)
    , Missing(columns)
  {
  }

  /// Puts a height in where there is nan.
  void Fill(std::vector<double>& heights)
  {
    std::vector<std::size_t> waiting;
    for (std::size_t n = 0; n < heights.size(); ++n)
    {
      if (std::isnan(heights[n]))
      {
        waiting.push_back(n);
      }
    }
    const auto fill = [&](bool areSides)
    {
      for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;)
      {
        before = waiting.size();
        this->FillOnce(waiting, areSides, heights);
      }
    };
    fill(true);
    fill(false);
    this->Cuts = nullptr; // of what is between cuts
    fill(false);
  }

private:
  struct Found
  {
    double Height = std::nan("");
    double Distance = 0.0;
  };

  void FillOnce(std::vector<std::size_t>& waiting, bool areSides, std::vector<double>& heights) const
  {
    std::vector<double> found(waiting.size());
    ParallelFor(std::int64_t(waiting.size()), GapGrain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto n = std::size_t(first); n < std::size_t(last); ++n)
        {
          found[n] = this->HeightAt(this->Columns[waiting[n]], areSides, heights);
        }
      });
    std::vector<std::size_t> left;
    for (std::size_t n = 0; n < waiting.size(); ++n)
    {
      heights[waiting[n]] = found[n];
      if (std::isnan(found[n]))
      {
        left.push_back(waiting[n]);
      }
    }
    waiting.swap(left);
  }

  double HeightAt(const PlanePoint& column, bool areSides, const std::vector<double>& heights) const
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
      const Found a = this->Look(column, step, heights);
      const Found b = this->Look(column, { -step.X, -step.Y }, heights);
      const bool areBoth = !std::isnan(a.Height) && !std::isnan(b.Height);
      if (areBoth)
      {
        add((a.Height * b.Distance + b.Height * a.Distance) / (a.Distance + b.Distance),
          length * (a.Distance + b.Distance));
      }
      for (const Found& one : { a, b })
      {
        if (!areSides && !areBoth && !std::isnan(one.Height))
        {
          add(one.Height, length * one.Distance);
        }
      }
    }
    return sum / weights; // nan where nothing was found
  }

  /// The nearest height in a direction.
  Found Look(PlanePoint column, const PlanePoint& step, const std::vector<double>& heights) const
  {
    for (int distance = 1; distance <= Farthest && !this->IsCut(column, step); ++distance)
    {
      column = { column.X + step.X, column.Y + step.Y };
      const PointId known = this->Known.PointAt(column);
      if (known != NoPoint)
      {
        return { this->Horizon.Heights[known], double(distance) };
      }
      const PointId filled = this->Missing.PointAt(column);
      if (filled != NoPoint && !std::isnan(heights[std::size_t(filled)]))
      {
        return { heights[std::size_t(filled)], double(distance) };
      }
    }
    return {};
  }

  bool IsCut(const PlanePoint& column, const PlanePoint& step) const
  {
    return this->Cuts && this->Cuts->IsCutBeside(column, step);
  }

  static constexpr int Farthest = 256; // columns
  static constexpr std::int64_t GapGrain = 1024; // columns that a thread takes at a time

  const HorizonView& Horizon;
  const LinkCuts* Cuts;
  const std::vector<PlanePoint>& Columns;
  const ColumnIndex Known;
  const ColumnIndex Missing;
};

/// Puts heights that were not known between those of the horizons above and below.
void PutBetween(HeightStack& heights, const CommonColumns& columns, bool growDownwards)
{
  const double upwards = growDownwards ? -1.0 : 1.0;
  for (std::size_t column = 0; column < columns.Columns.size(); ++column)
  {
    double above = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < heights.size(); ++n)
    {
      double height = upwards * heights[n][column];
      if (columns.Points[n][column] == NoPoint)
      {
        std::size_t next = n + 1;
        while (next < heights.size() && columns.Points[next][column] == NoPoint)
        {
          ++next;
        }
        const double below = next < heights.size() ? upwards * heights[next][column] : -above;
        height = std::min(std::max(height, next < heights.size() ? below : height), above);
      }
      above = height;
      heights[n][column] = upwards * height;
    }
  }
}

/// Columns in which a height is still missing, as the horizon has none far and wide, are left out.
void DropIncomplete(CommonColumns& columns, HeightStack& heights)
{
  std::vector<unsigned char> isComplete(columns.Columns.size(), 1);
  for (std::vector<double>& own : heights)
  {
    for (std::size_t n = 0; n < own.size(); ++n)
    {
      isComplete[n] = std::isnan(own[n]) ? 0 : isComplete[n];
    }
  }
  for (std::vector<double>& own : heights)
  {
    std::size_t n = 0;
    own.erase(std::remove_if(own.begin(), own.end(), [&](double) { return isComplete[n++] == 0; }), own.end());
  }
  KeepColumns(columns, [&](std::size_t n) { return isComplete[n] != 0; });
}
}

//----------------------------------------------------------------------------------------------------------------------
OrderedStack MakeStack(
  const std::vector<HorizonView>& horizons, LayerDomain domain, const CrossingOptions& options, const Monitor& monitor)
{
  CheckHorizons(horizons, options);
  CommonColumns common = domain == LayerDomain::Common ? FindCommonColumns(horizons) : FindColumnsOfLayers(horizons);
  if (common.Columns.empty())
  {
    throw NothingInCommon(horizons, options);
  }
  OrderedStack stack;
  stack.Columns.swap(common.Columns);
  stack.Heights = HeightsOf(horizons, common);
  stack.Repair = RepairCrossings(stack.Heights, options, monitor);
  return stack;
}

//----------------------------------------------------------------------------------------------------------------------
CompletedColumns CompleteColumns(const std::vector<HorizonView>& horizons, PlanePoints columns, const Loops& loops,
  bool withLoops, const LinkCuts* cuts, const CrossingOptions& options)
{
  CompletedColumns completed;
  const bool areSame = std::all_of(horizons.begin(), horizons.end(),
    [&columns](const HorizonView& horizon) { return horizon.Columns.size() == columns.size(); });
  if (areSame)
  {
    completed.Heights.resize(horizons.size());
    completed.Repair.Horizons.resize(horizons.size());
    completed.Repair.Interfaces.resize(horizons.size() - 1);
    return completed;
  }
  CommonColumns others = FindColumnsOfAny(horizons);
  const LoopRows rows(columns, loops);
  const ColumnIndex index(columns);
  const auto loopAt = [&](const PlanePoint& column)
  {
    const PointId on = rows.LoopAt(column);
    return on == NoPoint ? rows.LoopAround(column) : withLoops ? on : NoPoint;
  };
  KeepColumns(others,
    [&](std::size_t n)
    {
      const PlanePoint& column = others.Columns[n];
      return index.PointAt(column) == NoPoint && loopAt(column) != NoPoint;
    });
  completed.Heights = HeightsOf(horizons, others);
  completed.Repair = RepairCrossings(completed.Heights, options);
  for (std::size_t n = 0; n < horizons.size() && !others.Columns.empty(); ++n)
  {
    GapHeights(horizons[n], cuts, others.Columns).Fill(completed.Heights[n]);
  }
  DropIncomplete(others, completed.Heights);
  PutBetween(completed.Heights, others, options.HeightsGrowDownwards);
  completed.Columns = std::move(others.Columns);
  for (const PlanePoint& column : completed.Columns)
  {
    completed.OnLoops.push_back(loopAt(column));
  }
  return completed;
}

//----------------------------------------------------------------------------------------------------------------------
Loops PassThrough(const Loops& loops, PlanePoints columns, std::size_t first)
{
  const ColumnIndex index(columns);
  Loops passing;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    const PointId* const points = loops.begin(loop);
    for (std::size_t n = 0; n < loops.Length(loop); ++n)
    {
      const PlanePoint& a = columns[std::size_t(points[n])];
      const PlanePoint& b = columns[std::size_t(points[(n + 1) % loops.Length(loop)])];
      passing.Append(points[n]);
      ForEachColumnBetween(a, b,
        [&](const PlanePoint& column, double)
        {
          const PointId on = index[index.Place(column)];
          if (on != NoPoint && std::size_t(on) >= first)
          {
            passing.Append(on);
          }
        });
    }
    passing.Close();
  }
  return passing;
}

//----------------------------------------------------------------------------------------------------------------------
void AddColumns(const CompletedColumns& columns, OrderedStack& stack)
{
  stack.Completed += columns.Columns.size();
  stack.Columns.insert(stack.Columns.end(), columns.Columns.begin(), columns.Columns.end());
  for (std::size_t n = 0; n < stack.Heights.size(); ++n)
  {
    stack.Heights[n].insert(stack.Heights[n].end(), columns.Heights[n].begin(), columns.Heights[n].end());
    stack.Repair.Horizons[n].Add(columns.Repair.Horizons[n]);
  }
  for (std::size_t n = 0; n < stack.Repair.Interfaces.size(); ++n)
  {
    stack.Repair.Interfaces[n].Add(columns.Repair.Interfaces[n]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
RepairedHorizons RepairHorizons(
  const std::vector<HorizonView>& horizons, const CrossingOptions& options, const Monitor& monitor)
{
  CheckHorizons(horizons, options);
  const CommonColumns columns = FindColumnsOfAny(horizons);
  HeightStack stack = HeightsOf(horizons, columns);
  RepairedHorizons repaired;
  repaired.Repair = RepairCrossings(stack, options, monitor);
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    std::vector<double> heights(horizons[n].Columns.size());
    for (std::size_t column = 0; column < columns.Columns.size(); ++column)
    {
      const PointId point = columns.Points[n][column];
      if (point != NoPoint)
      {
        heights[std::size_t(point)] = stack[n][column];
      }
    }
    repaired.Heights.push_back(std::move(heights));
  }
  return repaired;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::size_t> OrderByHeight(const std::vector<HorizonView>& horizons, const CrossingOptions& options)
{
  constexpr double MostBelow = 0.25;
  const CommonColumns common = FindCommonColumns(horizons);
  if (common.Columns.empty())
  {
    throw NothingInCommon(horizons, options);
  }
  const double upwards = options.HeightsGrowDownwards ? -1.0 : 1.0;
  const auto height = [&](std::size_t n, std::size_t column)
  { return upwards * horizons[n].Heights[common.Points[n][column]]; };
  std::vector<double> sums(horizons.size(), 0.0);
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    for (std::size_t column = 0; column < common.Columns.size(); ++column)
    {
      sums[n] += height(n, column);
    }
  }
  std::vector<std::size_t> order(horizons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&sums](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
  for (std::size_t n = 0; n + 1 < order.size(); ++n)
  {
    std::array<double, 2> columns = { 0.0, 0.0 }; // in which the upper one is above, and below
    for (std::size_t column = 0; column < common.Columns.size(); ++column)
    {
      const double between = height(order[n], column) - height(order[n + 1], column);
      columns[0] += between > 0.0 ? 1.0 : 0.0;
      columns[1] += between < 0.0 ? 1.0 : 0.0;
    }
    const double below = columns[1] / std::max(1.0, columns[0] + columns[1]);
    if (below > MostBelow)
    {
      const auto percent = std::lround(100.0 * below);
      throw InputError(NameOf(order[n], options) + " is above " + NameOf(order[n + 1], options) + " in " +
        std::to_string(100 - percent) + " % of their columns and below in " + std::to_string(percent) +
        " %, expected an order: give the uppermost horizon first, with Order AsGiven");
    }
  }
  return order;
}
}
