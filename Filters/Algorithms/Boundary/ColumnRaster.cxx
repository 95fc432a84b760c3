// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnRaster.h"

#include <algorithm>
#include <sstream>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
InputError SameColumnError(PointId first, PointId second, const PlanePoint& column)
{
  std::ostringstream text;
  text << "points " << first << " and " << second << " both in column (" << column.X << ", " << column.Y
       << "), expected at most one point of a horizon in a column";
  return InputError(text.str());
}

//----------------------------------------------------------------------------------------------------------------------
ColumnRaster::ColumnRaster(const std::vector<PlanePoint>& columns, std::int32_t rim)
{
  if (columns.empty())
  {
    return;
  }
  const auto x = std::minmax_element(
    columns.begin(), columns.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.X < b.X; });
  const auto y = std::minmax_element(
    columns.begin(), columns.end(), [](const PlanePoint& a, const PlanePoint& b) { return a.Y < b.Y; });
  this->MinX = std::int64_t(x.first->X) - rim;
  this->MinY = std::int64_t(y.first->Y) - rim;
  this->SizeX = std::int64_t(x.second->X) + rim + 1 - this->MinX;
  this->SizeY = std::int64_t(y.second->Y) + rim + 1 - this->MinY;
  this->Points.assign(std::size_t(this->SizeX * this->SizeY), NoPoint);
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    PointId& point = this->Points[std::size_t(this->Place(columns[n]))];
    if (point != NoPoint)
    {
      throw SameColumnError(point, PointId(n), columns[n]);
    }
    point = PointId(n);
  }
}
}
