// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which corners of the boundary loops of a horizon can be cut off, so that no loops come to cross and every point stays
// on its side of them.
//
// When a loop goes straight from a to b instead of by way of m, only the triangle a, m, b changes sides:
//
//          m
//         / \             As long as no other point lies in the triangle or on its sides, no other loop does: it would
//     ---a---b---         have to cross a-m or m-b, or to have a point inside. So loops that did not cross still do
//     not,
//                         and no point changes sides or lies on the new edge.

#ifndef SeismicHorizonsLoopGuard_h
#define SeismicHorizonsLoopGuard_h

#include "Common/CellGrid.h"
#include "Common/SpacePoints.h"

#include <vector>

namespace SeismicHorizons
{
/// Answers are exact for places that are multiples of 2^-20 of a column, as all on a lattice are.
class LoopGuard
{
public:
  /// `points` are all points of the horizon, in lattice units, on the boundary or inside.
  explicit LoopGuard(const SpacePoints& points);

  /// True when no point that is left lies in the triangle a, m, b or on its sides, other than these three.
  bool IsClear(PointId a, PointId m, PointId b) const;

  /// Takes a point away.
  void Remove(PointId point) { this->Removed[std::size_t(point)] = true; }

private:
  /// A place in the plane, in whole parts of a column.
  struct FinePoint
  {
    std::int64_t X;
    std::int64_t Y;
  };

  FinePoint Fine(PointId point) const;
  RowSegment Side(PointId a, PointId b) const;
  bool IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const;

  const SpacePoints& Points;
  const std::vector<PlanePoint> Columns; // of each point
  const CellGrid Grid;
  const PointLists InColumn;
  std::vector<bool> Removed;
};
}

#endif
