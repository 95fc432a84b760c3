// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The columns that horizons of a stack have in common.

#ifndef SeismicHorizonsCommonColumns_h
#define SeismicHorizonsCommonColumns_h

#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// A horizon in memory that others own, at most one point in a column.
struct HorizonView
{
  PlanePoints Columns;
  const double* Heights = nullptr;
  /// Points from this one on were put into holes and gaps (OrderedStack.h).
  std::size_t FirstFilled = std::numeric_limits<std::size_t>::max();

  /// By point, 1 if an earlier stage filled it, 2 if one extrapolated it. May be null.
  const unsigned char* IsFilled = nullptr;

  bool Knows(PointId point) const { return point != NoPoint && std::size_t(point) < this->FirstFilled; }
  std::size_t NumberOfKnown() const { return std::min(this->FirstFilled, this->Columns.size()); }
};

/// Columns of a stack, row by row from the least y, in each row by x.
struct CommonColumns
{
  std::vector<PlanePoint> Columns;
  std::vector<std::vector<PointId>> Points; // by horizon, then by column; NoPoint where it has none
};

/// The columns in which at least `together` successive horizons have points: 1 finds those of any horizon, 2 those of
/// layers. Throws InputError if two points of a horizon are in one column.
CommonColumns FindStackColumns(const std::vector<HorizonView>& horizons, std::size_t together);
}

#endif
