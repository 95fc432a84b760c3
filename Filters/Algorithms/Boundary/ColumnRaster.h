// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// For each column of the bounding box of a horizon the point that stands there. An empty rim around the box lets
// searches look at neighbours without a test for its sides. 4 bytes per column.

#ifndef SeismicHorizonsColumnRaster_h
#define SeismicHorizonsColumnRaster_h

#include "Common/Errors.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// What is wrong when two points, the lesser number first, are in one column.
InputError SameColumnError(PointId first, PointId second, const PlanePoint& column);

class ColumnRaster
{
public:
  /// `rim` is the width of the rim in columns. Throws InputError when two points stand in the same column.
  explicit ColumnRaster(const std::vector<PlanePoint>& columns, std::int32_t rim = 1);

  /// How many columns and rows there are, with the rim.
  std::int64_t Width() const { return this->SizeX; }
  std::int64_t Height() const { return this->SizeY; }

  /// The place of a column, which is its position in the raster, row by row: that above it has a place Width() further.
  std::int64_t Place(const PlanePoint& column) const
  {
    return (std::int64_t(column.Y) - this->MinY) * this->SizeX + (std::int64_t(column.X) - this->MinX);
  }

  /// The point at a place, or NoPoint.
  PointId operator[](std::int64_t place) const { return this->Points[std::size_t(place)]; }

private:
  std::int64_t MinX = 0;
  std::int64_t MinY = 0;
  std::int64_t SizeX = 0;
  std::int64_t SizeY = 0;
  std::vector<PointId> Points;
};
}

#endif
