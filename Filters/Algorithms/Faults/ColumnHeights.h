// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a horizon by column. A column has a number in the grid, the bounding box, and a place in the raster, which
// is held in memory. They are usually equal. If points are scattered in a much larger box, the raster omits most rows
// and grid columns without points:
//
//    grid    ooo.................ooo      raster    ooo........ooo
//
// `Margin` of them remain between points. Methods with a smaller reach find the same in the raster as in the grid,
// while memory and time do not depend on distances between separate parts of the horizon.

#ifndef SeismicHorizonsColumnHeights_h
#define SeismicHorizonsColumnHeights_h

#include "Common/Horizon/Types.h"
#include "LinkGrid.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
class ColumnHeights
{
public:
  static constexpr std::int64_t Margin = 26;

  /// Throws InputError for no points, heights that are not finite, and two points in one column.
  ColumnHeights(PlanePoints columns, const std::vector<double>& height);

  const LinkGrid& Grid() const { return this->Box; }
  /// The tolerance is a thousandth.
  bool AreWhole() const { return this->Whole; }
  /// This is NaN without a point.
  double operator[](std::int64_t column) const
  {
    const std::int64_t place = this->PlaceOf(column);
    return place < 0 ? std::numeric_limits<double>::quiet_NaN() : this->Values[place];
  }

  const LinkGrid& Raster() const { return this->Places; }
  const double* Row(std::int64_t y) const { return this->Values.data() + y * this->Places.Width(); }
  double At(std::int64_t place) const { return this->Values[place]; }
  /// ToRaster() returns -1 if the column was omitted.
  std::int64_t ToGrid(std::int64_t link) const;
  std::int64_t ToRaster(std::int64_t link) const;

private:
  std::int64_t PlaceOf(std::int64_t column) const
  {
    return this->ColumnsKept.empty() ? column : this->FindPlace(column);
  }
  std::int64_t FindPlace(std::int64_t column) const;

  LinkGrid Box;
  // Coordinates of the raster in the grid, counted from the least column of the box; empty if none is omitted.
  std::vector<std::int64_t> ColumnsKept;
  std::vector<std::int64_t> RowsKept;
  LinkGrid Places;
  std::vector<double> Values;
  bool Whole = true;
};
}

#endif
