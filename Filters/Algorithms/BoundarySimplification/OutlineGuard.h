// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which corners of the outlines of a horizon can be cut off without harm.
//
// When a loop goes straight from a to b instead of by way of m, all that changes lies in the triangle a, m, b. If no
// other point is in it or on its sides, no other loop is either (it would have to cross a-m or m-b, or end inside): so
// loops that did not cross still do not, and no point changes sides or comes to lie on the new edge.

#ifndef SeismicHorizonsOutlineGuard_h
#define SeismicHorizonsOutlineGuard_h

#include "Common/CellGrid.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Answers are exact for places that are multiples of 2^-20 of a column, as all on a lattice are.
class OutlineGuard
{
public:
  /// `points` are all points of the horizon, in lattice units, on the boundary or inside.
  explicit OutlineGuard(const std::vector<SpacePoint>& points);

  /// True when no point that is left lies in the triangle or on its sides, other than its corners.
  bool IsClear(PointId a, PointId m, PointId b) const;

  /// Takes a point away.
  void Remove(PointId point) { this->Removed[std::size_t(point)] = true; }

private:
  /// A place in parts of a column.
  struct FinePoint
  {
    std::int64_t X;
    std::int64_t Y;
  };

  FinePoint Fine(PointId point) const;
  bool IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const;

  const std::vector<SpacePoint>& Points;
  const std::vector<PlanePoint> Columns; // the column around each point
  const CellGrid Grid;
  const PointLists InColumn;
  std::vector<bool> Removed;
};
}

#endif
