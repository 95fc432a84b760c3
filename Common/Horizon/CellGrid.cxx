// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellGrid.h"

#include "PlaneGeometry.h"

#include <limits>

namespace SeismicHorizons
{
namespace
{
std::int64_t FloorToMultiple(std::int64_t value, std::int64_t unit)
{
  const std::int64_t rest = value % unit;
  return value - (rest < 0 ? rest + unit : rest);
}
}

//----------------------------------------------------------------------------------------------------------------------
CellGrid::CellGrid(const std::vector<PlanePoint>& points, std::int32_t unit, std::int64_t cellSize)
  : Side(std::min<std::int64_t>(cellSize, std::numeric_limits<std::int32_t>::max())) // Exceeds any horizon.
  , Inverse((this->Side & (this->Side - 1)) == 0 ? 1.0 / double(this->Side) : 0.0)
{
  const PlaneBox box(points);
  this->MinX = FloorToMultiple(box.Least.X, unit);
  this->MinY = FloorToMultiple(box.Least.Y, unit);
  this->CellsX = (box.Greatest.X - this->MinX) / this->Side + 1;
  this->CellsY = (box.Greatest.Y - this->MinY) / this->Side + 1;
}

//----------------------------------------------------------------------------------------------------------------------
PointLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points)
{
  return PointLists(grid.Size(),
    [&](auto&& add)
    {
      for (std::size_t point = 0; point < points.size(); ++point)
      {
        add(grid.CellOf(points[point]), PointId(point));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
EdgeLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points, const Loops& boundary)
{
  return EdgeLists(grid.Size(),
    [&](auto&& add)
    {
      boundary.ForEachEdge(
        [&](PointId from, PointId to)
        {
          grid.ForEachCellAlong(points[std::size_t(from)], points[std::size_t(to)],
            [&](std::int64_t cell) {
              add(cell, Edge{ from, to });
            });
        });
    });
}
}
