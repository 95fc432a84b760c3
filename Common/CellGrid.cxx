// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellGrid.h"

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
  : Side(std::min<std::int64_t>(cellSize, std::numeric_limits<std::int32_t>::max())) // wider than any horizon
  , Inverse((this->Side & (this->Side - 1)) == 0 ? 1.0 / double(this->Side) : 0.0)
{
  PlanePoint low = points.front();
  PlanePoint high = low;
  for (const PlanePoint& p : points)
  {
    low = { std::min(low.X, p.X), std::min(low.Y, p.Y) };
    high = { std::max(high.X, p.X), std::max(high.Y, p.Y) };
  }
  this->MinX = FloorToMultiple(low.X, unit);
  this->MinY = FloorToMultiple(low.Y, unit);
  this->CellsX = (high.X - this->MinX) / this->Side + 1;
  this->CellsY = (high.Y - this->MinY) / this->Side + 1;
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
              add(cell, BoundaryEdge{ from, to });
            });
        });
    });
}
}
