// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The heights of a horizon by column. A column has a number in the grid, which is the bounding box, and a place in the
// raster, which is what is held in memory. Usually both are the same. Where points are scattered over a box with many
// times as many columns, the raster leaves out most of the rows, and of the files (columns of one i), that have no
// point:
//
//     grid    ooo.................ooo      raster    ooo........ooo
//
// `Margin` of them stay between points. So what looks at fewer columns than that in each direction finds the same in
// the raster as in the grid, while memory and time are those of the parts of the horizon, wherever they lie.

#ifndef SeismicHorizonsColumnHeights_h
#define SeismicHorizonsColumnHeights_h

#include "Common/Types.h"
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

  /// Takes the column of each point. Throws InputError on no point, on a height that is not finite, and on two points
  /// in one column.
  ColumnHeights(PlanePoints columns, const std::vector<double>& height);

  const LinkGrid& Grid() const { return this->Box; }
  /// Whether all heights are whole numbers, to a thousandth.
  bool AreWhole() const { return this->Whole; }
  /// The height in a column of the grid, nan where it has no point.
  double operator[](std::int64_t column) const
  {
    const std::int64_t place = this->PlaceOf(column);
    return place < 0 ? std::numeric_limits<double>::quiet_NaN() : this->Values[place];
  }

  /// The numbers that columns and links have in the raster.
  const LinkGrid& Raster() const { return this->Places; }
  const double* Row(std::int64_t y) const { return this->Values.data() + y * this->Places.Width(); }
  double At(std::int64_t place) const { return this->Values[place]; }
  /// The grid's i, or j, of a file or row of the raster, from the least of the box.
  std::int64_t GridX(std::int64_t x) const { return this->FilesKept.empty() ? x : this->FilesKept[x]; }
  std::int64_t GridY(std::int64_t y) const { return this->RowsKept.empty() ? y : this->RowsKept[y]; }
  /// The same link in the grid, and in the raster, where it is -1 when its column was left out.
  std::int64_t ToGrid(std::int64_t link) const;
  std::int64_t ToRaster(std::int64_t link) const;

private:
  std::int64_t PlaceOf(std::int64_t column) const { return this->FilesKept.empty() ? column : this->FindPlace(column); }
  std::int64_t FindPlace(std::int64_t column) const;

  LinkGrid Box;
  // Of the grid, ascending; both empty when none is left out.
  std::vector<std::int64_t> FilesKept;
  std::vector<std::int64_t> RowsKept;
  LinkGrid Places;
  std::vector<double> Values;
  bool Whole = true;
};
}

#endif
