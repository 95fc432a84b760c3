// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellLeaves.h"

#include "CellSides.h"
#include "CellSorter.h"
#include "Common/Errors.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace SeismicHorizons
{
namespace
{
std::int64_t CheckedCellSize(const BoundedHorizon& horizon, int columns)
{
  CheckAtLeast("cell size", columns, 1, " column");
  return std::int64_t(columns) * horizon.SubVoxelsPerColumn;
}
}

//----------------------------------------------------------------------------------------------------------------------
CellLeaves::CellLeaves(const BoundedHorizon& horizon, int columns, const Monitor& monitor)
  : Input(horizon)
  , Scale(1.0 / horizon.SubVoxelsPerColumn)
  , Side(CheckedCellSize(horizon, columns))
  , Cells(horizon.Plane, horizon.SubVoxelsPerColumn, this->Side)
  , OnBoundary(horizon.Boundary.MarkPoints(horizon.Plane.size()))
  , Marks(horizon.Plane.size(), 0)
{
  if (this->Cells.Size() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw InputError("cell size " + std::to_string(columns) +
      ", expected one that gives less than 2^32 cells: there are " + std::to_string(this->Cells.Size()));
  }
  monitor.Progress(0.0);
  this->SortPoints(monitor);
  if (horizon.Cuts)
  {
    this->FindSides();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CellLeaves::SortPoints(const Monitor& monitor)
{
  const std::size_t size = this->Input.Plane.size();
  this->Points.reset(new PointId[size]); // not a vector, which would write to all of it on one thread first
  this->CellEnds.assign(std::size_t(this->Cells.Size()) + 1, 0);
  SortIntoCells(this->Cells, this->Input.Plane, this->CellEnds, this->Points.get(), monitor);
  this->CellEnds.back() = std::uint32_t(size);
}

//----------------------------------------------------------------------------------------------------------------------
// The first side of each patch in a cell has the number of the patch, and all others have numbers of their own.
void CellLeaves::FindSides()
{
  this->Sides = this->Input.Patch;
  std::int64_t next = std::int64_t(*std::max_element(this->Sides.begin(), this->Sides.end())) + 1;
  // A cell may be far larger than the horizon.
  const PlaneBox box(this->Input.Plane);
  const std::int64_t column = this->Input.SubVoxelsPerColumn;
  const auto columns = [&](std::int64_t least, std::int64_t greatest)
  { return std::int32_t(std::min(this->Side / column, (greatest - least) / column + 2)); };
  CellSides sides(*this->Input.Cuts, columns(box.Least.X, box.Greatest.X), columns(box.Least.Y, box.Greatest.Y));
  for (std::int64_t cell = 0; cell < this->Cells.Size(); ++cell)
  {
    const PlanePoint corner = this->Cells.Corner(cell);
    const PlanePoint least{ std::int32_t(corner.X / column), std::int32_t(corner.Y / column) };
    if (this->Begin(cell) == this->Begin(cell + 1) || !sides.HasCut(least))
    {
      continue;
    }
    sides.Find(least);
    std::map<std::int32_t, std::map<std::int32_t, std::int32_t>> numbers; // by patch, then by side of the cell
    for (const PointId* point = this->Begin(cell); point != this->Begin(cell + 1); ++point)
    {
      const std::int32_t patch = this->Patch(*point);
      std::map<std::int32_t, std::int32_t>& ofPatch = numbers[patch];
      const auto side = ofPatch.emplace(sides[this->ColumnOf(*point)], patch);
      if (side.second && ofPatch.size() > 1)
      {
        side.first->second = std::int32_t(next++);
      }
      this->Sides[std::size_t(*point)] = side.first->second;
    }
  }
  if (next > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError("patch numbers up to " +
      std::to_string(*std::max_element(this->Input.Patch.begin(), this->Input.Patch.end())) +
      ", expected lower ones: with the sides of cut cells there are too many");
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The column nearest to a point, of those of its cell.
PlanePoint CellLeaves::ColumnOf(PointId point) const
{
  const std::int64_t column = this->Input.SubVoxelsPerColumn;
  const PlanePoint& place = this->Plane(point);
  const PlanePoint corner = this->Cells.Corner(this->Cells.CellOf(place));
  const auto nearest = [&](std::int64_t at, std::int64_t least)
  {
    const std::int64_t columns = std::min((at - least + column / 2) / column, this->Side / column - 1);
    return std::int32_t(least / column + columns);
  };
  return { nearest(place.X, corner.X), nearest(place.Y, corner.Y) };
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t CellLeaves::CountMerging(std::int64_t cell) const
{
  const auto begin = this->Marks.begin() + this->CellEnds[std::size_t(cell)];
  const auto end = this->Marks.begin() + this->CellEnds[std::size_t(cell) + 1];
  return std::uint32_t(std::count_if(begin, end, [](unsigned mark) { return MergesInner(mark); }));
}
}
