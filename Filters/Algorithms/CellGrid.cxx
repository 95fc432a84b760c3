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
  : CellSize(std::min<std::int64_t>(cellSize, std::numeric_limits<std::int32_t>::max())) // wider than any horizon
{
  const auto x = std::minmax_element(
    points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.X < b.X; });
  const auto y = std::minmax_element(
    points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.Y < b.Y; });
  this->MinX = FloorToMultiple(x.first->X, unit);
  this->MinY = FloorToMultiple(y.first->Y, unit);
  this->CellsX = (x.second->X - this->MinX) / this->CellSize + 1;
  this->CellsY = (y.second->Y - this->MinY) / this->CellSize + 1;
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
HopLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points, const Loops& boundary)
{
  return HopLists(grid.Size(),
    [&](auto&& add)
    {
      boundary.ForEachHop(
        [&](PointId from, PointId to)
        {
          grid.ForEachCellAlong(points[std::size_t(from)], points[std::size_t(to)],
            [&](std::int64_t cell) {
              add(cell, Hop{ from, to });
            });
        });
    });
}
}
