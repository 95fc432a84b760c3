// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a run follow each other by hops. Each column from k before a run to k after it is at most k columns from a
// point of the run, so that two runs in rows at most k apart are connected if one of them, extended by k, overlaps the
// other.
//
// A component is inside a loop if its first point is. Rows with first points are scanned from left to right, while the
// scan tracks the loops that it enters and leaves.

#include "PatchComponents.h"

#include "Common/Base/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
struct PatchRun
{
  std::int32_t First;
  std::int32_t Last;
  std::int32_t Set;
};

class RunList
{
public:
  RunList(const ColumnIndex& index, int radius)
    : Index(index)
    , Radius(radius)
    , RowEnds(1, 0)
  {
  }

  void AddRow(std::int64_t row)
  {
    const std::size_t begin = this->Runs.size();
    const std::int64_t first = row * this->Index.Width();
    this->Index.ForEachPoint(first, first + this->Index.Width(),
      [&](std::int64_t place, PointId)
      {
        const auto x = std::int32_t(place - first);
        if (this->Runs.size() > begin && x - this->Runs.back().Last <= this->Radius)
        {
          this->Runs.back().Last = x;
        }
        else
        {
          this->Runs.push_back({ x, x, this->Sets.Add() });
        }
      });
    this->RowEnds.push_back(this->Runs.size());
    for (std::int64_t below = std::max<std::int64_t>(0, row - this->Radius); below < row; ++below)
    {
      this->JoinRows(std::size_t(below), std::size_t(row));
    }
  }

  void Number(PatchComponents& result)
  {
    std::vector<std::int32_t> number(this->Runs.size(), -1);
    for (std::size_t row = 0; row + 1 < this->RowEnds.size(); ++row)
    {
      for (std::size_t n = this->RowEnds[row]; n < this->RowEnds[row + 1]; ++n)
      {
        this->NumberRun(std::int64_t(row) * this->Index.Width(), this->Runs[n], number, result);
      }
    }
  }

private:
  void JoinRows(std::size_t rowA, std::size_t rowB)
  {
    std::size_t a = this->RowEnds[rowA];
    std::size_t b = this->RowEnds[rowB];
    while (a < this->RowEnds[rowA + 1] && b < this->RowEnds[rowB + 1])
    {
      const PatchRun& runA = this->Runs[a];
      const PatchRun& runB = this->Runs[b];
      if (runA.First <= runB.Last + this->Radius && runB.First <= runA.Last + this->Radius)
      {
        this->Sets.Join(runA.Set, runB.Set);
      }
      // The next run of the other row begins more than k columns after the run that ends first.
      ++(runA.Last < runB.Last ? a : b);
    }
  }

  void NumberRun(std::int64_t rowPlace, const PatchRun& run, std::vector<std::int32_t>& number, PatchComponents& result)
  {
    std::int32_t& component = number[this->Sets.Find(run.Set)];
    if (component < 0)
    {
      component = std::int32_t(result.First.size());
      result.First.push_back(rowPlace + run.First);
    }
    this->Index.ForEachPoint(rowPlace + run.First, rowPlace + run.Last + 1,
      [&](std::int64_t, PointId point) { result.Component[point] = component; });
  }

  const ColumnIndex& Index;
  const int Radius;
  std::vector<PatchRun> Runs;
  std::vector<std::size_t> RowEnds;
  DisjointSets Sets;
};

struct HopCrossing
{
  double X;
  std::size_t Loop;
};

using PlaceVisitor = std::function<void(std::size_t, const std::vector<std::size_t>&)>;

class LoopReader
{
public:
  LoopReader(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places, const Loops& loops)
    : Columns(columns)
    , Index(index)
    , Places(places)
    , Boundary(loops)
    , RowNumber(std::size_t(index.Height()), -1)
  {
  }

  void PatchRun(const PlaceVisitor& visit)
  {
    this->NumberRows();
    this->FindCrossings();
    std::size_t place = 0;
    for (std::vector<HopCrossing>& crossings : this->Crossings)
    {
      std::sort(
        crossings.begin(), crossings.end(), [](const HopCrossing& a, const HopCrossing& b) { return a.X < b.X; });
      place = this->ReadRow(crossings, place, visit);
    }
  }

private:
  std::int64_t RowOf(std::int64_t place) const { return place / this->Index.Width(); }
  std::int64_t ColumnOf(std::int64_t place) const { return place % this->Index.Width(); }

  void NumberRows()
  {
    std::int32_t rows = 0;
    for (const std::int64_t place : this->Places)
    {
      std::int32_t& number = this->RowNumber[this->RowOf(place)];
      number = number < 0 ? rows++ : number;
    }
    this->Crossings.resize(std::size_t(rows));
  }

  void FindCrossings()
  {
    for (std::size_t loop = 0; loop < this->Boundary.Size(); ++loop)
    {
      this->Boundary.ForEachEdgeOf(loop,
        [&](PointId from, PointId to)
        {
          const std::int64_t a = this->Index.Place(this->Columns[from]);
          const std::int64_t b = this->Index.Place(this->Columns[to]);
          this->AddCrossings(std::min(a, b), std::max(a, b), loop);
        });
    }
  }

  /// The hop that continues at the upper end adds the crossing of that row. Rounding is harmless, as hops miss points
  /// by at least 1 / k columns.
  void AddCrossings(std::int64_t low, std::int64_t high, std::size_t loop)
  {
    const std::int64_t rows = std::max<std::int64_t>(1, this->RowOf(high) - this->RowOf(low));
    const double slope = double(this->ColumnOf(high) - this->ColumnOf(low)) / double(rows);
    for (std::int64_t row = this->RowOf(low); row < this->RowOf(high); ++row)
    {
      const std::int32_t number = this->RowNumber[row];
      if (number >= 0)
      {
        const double x = double(this->ColumnOf(low)) + slope * double(row - this->RowOf(low));
        this->Crossings[number].push_back({ x, loop });
      }
    }
  }

  std::size_t ReadRow(const std::vector<HopCrossing>& crossings, std::size_t place, const PlaceVisitor& visit)
  {
    const std::int64_t row = this->RowOf(this->Places[place]);
    std::vector<std::size_t> around;
    auto next = crossings.begin();
    for (; place < this->Places.size() && this->RowOf(this->Places[place]) == row; ++place)
    {
      for (; next != crossings.end() && next->X < double(this->ColumnOf(this->Places[place])); ++next)
      {
        EnterOrLeave(around, next->Loop);
      }
      visit(place, around);
    }
    return place;
  }

  static void EnterOrLeave(std::vector<std::size_t>& around, std::size_t loop)
  {
    const auto found = std::find(around.begin(), around.end(), loop);
    if (found == around.end())
    {
      around.push_back(loop);
    }
    else
    {
      around.erase(found);
    }
  }

  const PlanePoints Columns;
  const ColumnIndex& Index;
  const std::vector<std::int64_t>& Places;
  const Loops& Boundary;
  std::vector<std::int32_t> RowNumber; // by row of the index, or -1
  std::vector<std::vector<HopCrossing>> Crossings;
};

/// Outlines and holes alternate from outside to inside, once outlines of islands of other patches are ignored.
std::int32_t InnermostPatch(const std::vector<std::size_t>& around, const std::vector<std::int32_t>& patchOf)
{
  std::int32_t innermost = -1;
  std::size_t outlines = 0;
  std::size_t holes = 0;
  for (const std::size_t loop : around)
  {
    const bool isHole = loop >= patchOf.size();
    holes += isHole ? 1 : 0;
    if (!isHole && patchOf[loop] == std::int32_t(loop))
    {
      ++outlines;
      innermost = std::max(innermost, std::int32_t(loop));
    }
  }
  return outlines > holes ? innermost : -1;
}
}

//----------------------------------------------------------------------------------------------------------------------
PatchComponents FindPatchComponents(const ColumnIndex& index, std::size_t points, int radius)
{
  RunList runs(index, radius);
  for (std::int64_t row = 0; row < index.Height(); ++row)
  {
    runs.AddRow(row);
  }
  PatchComponents result;
  result.Component.resize(points, -1);
  runs.Number(result);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
void ForEachPlaceInLoops(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places,
  const Loops& loops, const PlaceVisitor& visit)
{
  LoopReader(columns, index, places, loops).PatchRun(visit);
}

//----------------------------------------------------------------------------------------------------------------------
// Components are numbered from below, so that each follows the component around it, and nested islands follow both.
std::vector<std::int32_t> AssignIslands(
  PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& first, const Loops& loops)
{
  std::vector<std::int32_t> patchOf(first.size());
  std::iota(patchOf.begin(), patchOf.end(), 0);
  if (first.size() > 1)
  {
    ForEachPlaceInLoops(columns, index, first, loops,
      [&patchOf](std::size_t part, const std::vector<std::size_t>& around)
      {
        const std::int32_t patch = InnermostPatch(around, patchOf);
        patchOf[part] = patch < 0 ? std::int32_t(part) : patch;
      });
  }
  return patchOf;
}
}
