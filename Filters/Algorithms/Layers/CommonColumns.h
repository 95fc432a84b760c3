// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where all horizons of a stack are.

#ifndef SeismicHorizonsCommonColumns_h
#define SeismicHorizonsCommonColumns_h

#include "Common/Types.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// A horizon whose points others own: the column of each, no two the same, and its height.
struct HorizonView
{
  PlanePoints Columns;
  const double* Heights = nullptr;
  /// The first of the points that were put into holes and gaps, behind those that were read.
  std::size_t FirstFilled = std::numeric_limits<std::size_t>::max();

  /// By point that was read, 1 for those that an earlier stage filled, 2 outside; null where it filled none.
  const unsigned char* IsFilled = nullptr;

  bool Knows(PointId point) const { return point != NoPoint && std::size_t(point) < this->FirstFilled; }
  std::size_t NumberOfKnown() const { return std::min(this->FirstFilled, this->Columns.size()); }
};

/// Columns that several horizons have, row by row from the least y, in each of them by x.
struct CommonColumns
{
  std::vector<PlanePoint> Columns;
  std::vector<std::vector<PointId>> Points; // for each horizon its points there
};

/// Throws InputError when two points of a horizon stand in one column.
CommonColumns FindCommonColumns(const std::vector<HorizonView>& horizons);

/// The same of columns that two neighbours of a stack have, whatever others do: NoPoint for horizons that have none
/// there.
CommonColumns FindColumnsOfLayers(const std::vector<HorizonView>& horizons);

/// The same of columns that any horizon has.
CommonColumns FindColumnsOfAny(const std::vector<HorizonView>& horizons);
}

#endif
