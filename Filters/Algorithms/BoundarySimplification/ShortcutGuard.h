// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which chains of boundary points can be replaced by straight edges, so that no loops come to cross and every point
// stays on its side of them.
//
//        o--o                    When an edge takes the place of a chain, what lies between the two changes sides. No
//       /    \    o--o           point may lie there, or on the edge, other than those of the chain. Then no edge of
//   ---o------o--/----o---       another chain crosses the new one: it can not cross the chain, and would have an end
//              \o                between the two. For the same reason two new edges never cross, in whatever order they
//                              are made, as their ends are among the points that may not lie there.

#ifndef SeismicHorizonsShortcutGuard_h
#define SeismicHorizonsShortcutGuard_h

#include "Common/SpacePoints.h"
#include "Common/Types.h"
#include "OccupiedColumns.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// All answers are exact.
class ShortcutGuard
{
public:
  /// `points` are all points of the horizon, in lattice units, on the boundary or inside. Throws InputError when one
  /// does not stand on a whole column.
  /// `isOnLoop` has for each of them 0 when no loop visits it.
  ShortcutGuard(const SpacePoints& points, const std::vector<unsigned char>& isOnLoop);

  /// Takes a chain, whose points between its ends no loop visits a second time.
  void SetChain(const std::vector<PointId>& chain);

  /// Whether the points of the chain between two positions can be dropped.
  bool IsClear(std::size_t from, std::size_t to);

private:
  PlanePoint ColumnAt(std::size_t position) const { return this->Points.Column(std::size_t(this->Chain[position])); }
  std::size_t& PositionOf(PointId point);
  void AddCrossings(const PlanePoint& from, const PlanePoint& to);
  bool IsClearBetween();
  bool IsClearAlong(const PlanePoint& from, const PlanePoint& to) const;
  bool IsClearAt(std::int64_t x, std::int64_t y) const;

  const SpacePoints& Points;
  const OccupiedColumns Occupied;
  std::vector<PointId> Chain;
  std::vector<std::size_t> Position; // in the chain, by the numbers of loop columns, for points between its ends
  std::size_t From = 0; // the positions that IsClear was asked about
  std::size_t To = 0;
  std::vector<std::uint64_t> Crossings; // see AddCrossings
};
}

#endif
