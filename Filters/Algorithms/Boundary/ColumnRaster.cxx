// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnRaster.h"

#include "Common/PlaneGeometry.h"

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
  const PlaneBox box(columns);
  this->MinX = std::int64_t(box.Least.X) - rim;
  this->MinY = std::int64_t(box.Least.Y) - rim;
  this->SizeX = std::int64_t(box.Greatest.X) + rim + 1 - this->MinX;
  this->SizeY = std::int64_t(box.Greatest.Y) + rim + 1 - this->MinY;
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
