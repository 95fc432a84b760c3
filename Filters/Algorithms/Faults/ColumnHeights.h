// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnHeights_h
#define SeismicHorizonsColumnHeights_h

#include "Common/Types.h"
#include "LinkGrid.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The heights of a horizon by column over its bounding box; nan in columns without a point.
class ColumnHeights
{
public:
  /// Takes the column of each point. Throws InputError on no point, on a height that is not finite, and on two points
  /// in one column.
  ColumnHeights(const std::vector<PlanePoint>& columns, const std::vector<double>& height);

  const LinkGrid& Grid() const { return this->Links; }
  /// Whether all heights are whole numbers, to a thousandth.
  bool AreWhole() const { return this->Whole; }

  double operator[](std::int64_t column) const { return this->Values[std::size_t(column)]; }
  const double* Row(std::int64_t y) const { return this->Values.data() + y * this->Links.Width(); }
  bool Has(std::int64_t column) const { return !std::isnan((*this)[column]); }

private:
  LinkGrid Links;
  std::vector<double> Values;
  bool Whole = true;
};
}

#endif
