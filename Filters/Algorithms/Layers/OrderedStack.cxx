// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OrderedStack.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <cassert>
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

/// Names two horizons without a column in common, if there are such.
InputError NothingInCommon(const std::vector<HorizonView>& horizons, const CrossingOptions& names)
{
  for (std::size_t a = 0; a < horizons.size(); ++a)
  {
    for (std::size_t b = a + 1; b < horizons.size(); ++b)
    {
      if (FindStackColumns({ horizons[a], horizons[b] }, 2).Columns.empty())
      {
        return InputError(NameOf(a, names) + " and " + NameOf(b, names) +
          " have no column in common, expected horizons that lie above each other");
      }
    }
  }
  return InputError("no column that all " + std::to_string(horizons.size()) +
    " horizons have, expected horizons that lie above each other");
}

/// nan where a horizon has no point, or none that was read, without filled ones.
HeightStack HeightsOf(const std::vector<HorizonView>& horizons, const CommonColumns& columns, bool withFilled)
{
  HeightStack stack;
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    std::vector<double> heights(columns.Points[n].size());
    ParallelFor(std::int64_t(heights.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        std::transform(columns.Points[n].begin() + first, columns.Points[n].begin() + last, heights.begin() + first,
          [&](PointId point)
          {
            const bool isOne = withFilled ? point != NoPoint : horizons[n].Knows(point);
            return isOne ? horizons[n].Heights[point] : std::nan("");
          });
      });
    stack.push_back(std::move(heights));
  }
  return stack;
}

// ---- Gaps ----------------------------------------------------------------------------------------------------------
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

  PointId LoopAt(const PlanePoint& column) const
  {
    const auto found = std::lower_bound(this->On.begin(), this->On.end(), Place{ column, 0 });
    return found != this->On.end() && found->Column == column ? found->Point : NoPoint;
  }

  /// A point of the loop to the left of a column inside, or NoPoint for columns outside.
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

CommonColumns SelectColumns(const CommonColumns& columns, const KeptPoints& kept)
{
  CommonColumns selected;
  selected.Columns = kept.Select(columns.Columns);
  for (const std::vector<PointId>& points : columns.Points)
  {
    selected.Points.push_back(kept.Select(points));
  }
  return selected;
}

// ---- The stack -----------------------------------------------------------------------------------------------------
struct StackPart
{
  CommonColumns Columns;
  OriginStack Origins;

  template <typename Keep>
  StackPart Select(Keep&& keep) const
  {
    const auto kept = KeptPoints::If(this->Columns.Columns.size(), keep);
    StackPart selected = { SelectColumns(this->Columns, kept), {} };
    for (const std::vector<HeightOrigin>& own : this->Origins)
    {
      selected.Origins.push_back(kept.Select(own));
    }
    return selected;
  }

  bool AreAllRead() const
  {
    return std::all_of(this->Origins.begin(), this->Origins.end(),
      [](const std::vector<HeightOrigin>& own) { return std::all_of(own.begin(), own.end(), IsRead); });
  }
};

/// Completes all columns; the stack gets the heights that the policy allows, and the others are left out.
class StackMaker
{
public:
  StackMaker(const std::vector<HorizonView>& horizons, const StackOptions& options)
    : Horizons(horizons)
    , Options(options)
  {
  }

  OrderedStack Run(const Monitor& monitor)
  {
    this->Result.Filled =
      FillHorizons(this->Horizons, this->Options.Missing, this->Options.Cuts, monitor.Step(0.0, 0.6));
    const std::vector<HorizonView>& filled = this->Result.Filled.Views;
    StackPart chosen;
    chosen.Columns = FindStackColumns(filled, 1);
    chosen.Origins = FindOrigins(filled, chosen.Columns, HeightsOf(filled, chosen.Columns, true));
    monitor.Progress(0.7);
    const auto isIn = [&](std::size_t n)
    { return IsIn(chosen.Origins, n, this->Options.Domain, this->Options.Missing.Policy); };
    const auto isLeftOut = [&](std::size_t n)
    { return !isIn(n) && IsIn(chosen.Origins, n, LayerDomain::EachLayer, MissingPolicy::Follow); };
    const StackPart others = chosen.Select(isLeftOut);
    chosen = chosen.Select(isIn);
    if (chosen.Columns.Columns.empty())
    {
      throw NothingInCommon(this->Horizons, this->Options.Crossings);
    }
    this->Result.LeftOut.resize(this->Horizons.size() - 1);
    CrossingOptions ofOthers = this->Options.Crossings;
    std::replace(ofOthers.Policies.begin(), ofOthers.Policies.end(), CrossingPolicy::Stop, CrossingPolicy::Mean);
    CrossingRepair none;
    this->LeaveOut(others, this->Complete(others, ofOthers, none, Monitor()), MissingPolicy::Void, true);
    this->Result.Heights = this->Complete(chosen, this->Options.Crossings, this->Result.Repair, monitor.Step(0.7, 1.0));
    this->LeaveOut(chosen, this->Result.Heights, this->Options.Missing.Policy, false);
    this->DropForbidden(chosen.Origins);
    this->Result.Columns = std::move(chosen.Columns.Columns);
    this->Result.Origins = std::move(chosen.Origins);
    if (this->Options.Missing.Policy == MissingPolicy::Void)
    {
      this->Result.Filled = { {}, {}, this->Horizons };
    }
    return std::move(this->Result);
  }

private:
  static bool IsIn(const OriginStack& origins, std::size_t column, LayerDomain domain, MissingPolicy policy)
  {
    std::size_t together = 0; // horizons above each other up to this one
    std::size_t most = 0;
    for (const std::vector<HeightOrigin>& own : origins)
    {
      together = Allows(policy, own[column]) ? together + 1 : 0;
      most = std::max(most, together);
    }
    return most >= (domain == LayerDomain::Common ? origins.size() : 2);
  }

  HeightStack Complete(
    const StackPart& part, const CrossingOptions& options, CrossingRepair& repair, const Monitor& monitor) const
  {
    const std::vector<HorizonView>& filled = this->Result.Filled.Views;
    HeightStack heights = HeightsOf(filled, part.Columns, false);
    repair = RepairCrossings(heights, options, monitor);
    if (!part.AreAllRead())
    {
      PutMissing(part.Origins, HeightsOf(filled, part.Columns, true), options, heights);
    }
    return heights;
  }

  /// Notes layers in all columns, or in those that the policy forbids.
  void LeaveOut(const StackPart& part, const HeightStack& heights, MissingPolicy policy, bool areAll)
  {
    for (std::size_t layer = 0; layer + 1 < heights.size(); ++layer)
    {
      for (std::size_t n = 0; n < heights[layer].size(); ++n)
      {
        const HeightOrigin top = part.Origins[layer][n];
        const HeightOrigin base = part.Origins[layer + 1][n];
        const bool isThere = top != HeightOrigin::None && base != HeightOrigin::None;
        if (isThere && (areAll || !Allows(policy, top) || !Allows(policy, base)))
        {
          this->Result.LeftOut[layer].Columns.push_back(part.Columns.Columns[n]);
          this->Result.LeftOut[layer].Thickness.push_back(std::abs(heights[layer][n] - heights[layer + 1][n]));
        }
      }
    }
  }

  void DropForbidden(OriginStack& origins)
  {
    for (std::size_t horizon = 0; horizon < origins.size(); ++horizon)
    {
      for (std::size_t n = 0; n < origins[horizon].size(); ++n)
      {
        HeightOrigin& origin = origins[horizon][n];
        if (!Allows(this->Options.Missing.Policy, origin))
        {
          origin = HeightOrigin::None;
          this->Result.Heights[horizon][n] = std::nan("");
        }
      }
    }
  }

  const std::vector<HorizonView>& Horizons;
  const StackOptions& Options;
  OrderedStack Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
OrderedStack MakeStack(const std::vector<HorizonView>& horizons, const StackOptions& options, const Monitor& monitor)
{
  CheckHorizons(horizons, options.Crossings);
  return StackMaker(horizons, options).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
CompletedColumns CompleteColumns(const std::vector<HorizonView>& horizons, PlanePoints columns, const Loops& loops,
  bool withLoops, const LinkCuts* cuts, const CrossingOptions& options)
{
  assert(horizons.size() >= 2);
  const auto isComplete = [&](const HorizonView& horizon) { return horizon.Columns.size() == columns.size(); };
  if (std::all_of(horizons.begin(), horizons.end(), isComplete))
  {
    return {}; // All columns of the horizons are those of the stack.
  }
  const CommonColumns all = FindStackColumns(horizons, 1);
  const LoopRows rows(columns, loops);
  const ColumnIndex index(columns);
  const auto loopAt = [&](const PlanePoint& column)
  {
    const PointId on = rows.LoopAt(column);
    return on == NoPoint ? rows.LoopAround(column) : withLoops ? on : NoPoint;
  };
  const auto isInside = [&](std::size_t n)
  { return index.PointAt(all.Columns[n]) == NoPoint && loopAt(all.Columns[n]) != NoPoint; };
  CommonColumns others = SelectColumns(all, KeptPoints::If(all.Columns.size(), isInside));
  HeightStack given = HeightsOf(horizons, others, true);
  for (std::size_t n = 0; n < horizons.size() && !others.Columns.empty(); ++n)
  {
    FillGaps(horizons[n], cuts, others.Columns, given[n]);
  }
  const auto isGiven = [&given](std::size_t n)
  { return std::none_of(given.begin(), given.end(), [n](const auto& heights) { return std::isnan(heights[n]); }); };
  const auto complete = KeptPoints::If(others.Columns.size(), isGiven);
  others = SelectColumns(others, complete);
  for (std::vector<double>& heights : given)
  {
    heights = complete.Select(heights);
  }
  CompletedColumns completed;
  completed.Heights = HeightsOf(horizons, others, false);
  completed.Repair = RepairCrossings(completed.Heights, options);
  completed.Origins = OriginsOf(horizons, others, HeightOrigin::Bridged);
  PutMissing(completed.Origins, given, options, completed.Heights);
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
  assert(first <= columns.size());
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
void CompletedColumns::AppendTo(std::vector<PlanePoint>& columns, HeightStack& heights) const
{
  assert(this->Heights.empty() || heights.empty() || this->Heights.size() == heights.size());
  assert(HaveAll(this->Heights, this->Columns.size()));
  columns.insert(columns.end(), this->Columns.begin(), this->Columns.end());
  for (std::size_t n = 0; n < this->Heights.size(); ++n)
  {
    heights[n].insert(heights[n].end(), this->Heights[n].begin(), this->Heights[n].end());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CompletedColumns::CountIn(OrderedStack& stack) const
{
  stack.Completed += this->Columns.size();
  stack.Repair.Add(this->Repair);
  for (std::size_t n = 0; n < this->Origins.size(); ++n)
  {
    stack.Origins[n].insert(stack.Origins[n].end(), this->Origins[n].begin(), this->Origins[n].end());
  }
}

//----------------------------------------------------------------------------------------------------------------------
RepairedHorizons RepairHorizons(
  const std::vector<HorizonView>& horizons, const CrossingOptions& options, const Monitor& monitor)
{
  CheckHorizons(horizons, options);
  const CommonColumns columns = FindStackColumns(horizons, 1);
  HeightStack stack = HeightsOf(horizons, columns, true);
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
  const CommonColumns common = FindStackColumns(horizons, horizons.size());
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
