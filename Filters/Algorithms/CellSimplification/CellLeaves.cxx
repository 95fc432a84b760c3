// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellLeaves.h"

#include "CellSorter.h"
#include "Common/Errors.h"
#include "Common/Parameters.h"

#include <limits>
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
std::uint32_t CellLeaves::CountMerging(std::int64_t cell) const
{
  const auto begin = this->Marks.begin() + this->CellEnds[std::size_t(cell)];
  const auto end = this->Marks.begin() + this->CellEnds[std::size_t(cell) + 1];
  return std::uint32_t(std::count_if(begin, end, [](unsigned mark) { return MergesInner(mark); }));
}
}
