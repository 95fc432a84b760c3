// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point that makes a triangle with an edge (thesis 5.3.4 to 5.3.6): of all points to the left of the edge that
// can be seen from it, the one whose circle with the edge is empty.
//
// Points are looked up in a grid of square cells with about one point each: first in growing squares around the
// middle of the edge until some point is found, then in what the circle of that point covers beyond the square.
//
// With constraints, a point counts only when the segment from the middle of the edge to it crosses none. Looking from
// the middle is enough: the third point is seen from every place on the edge, and a point of the circle that is seen
// from the middle would be seen from inside the triangle as well, which a constrained Delaunay triangle excludes.

#ifndef SeismicHorizonsThirdPointSearch_h
#define SeismicHorizonsThirdPointSearch_h

#include "CellGrid.h"
#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
class ThirdPointSearch
{
public:
  /// `points` and `boundary` must outlive the search. Coordinates are at least 0 and below 2^29. Throws InputError
  /// when two points are in one place, a point lies on a boundary edge, or two boundary edges cross; `names` gives
  /// the numbers by which messages call the points.
  ThirdPointSearch(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names);

  /// The third point for the edge from a to b, or NoPoint when nothing can be seen to the left of it. Two triangles
  /// never compete for the same place: InCircle leaves no ties.
  PointId Find(PointId a, PointId b) const;

private:
  struct Edge;
  struct Box;

  void CheckPlaces(const std::vector<PointId>& names) const;
  void CheckEdges(const std::vector<PointId>& names) const;

  Box Everything() const;
  Box SquareAround(const Edge& edge, std::int64_t radius) const;
  Box LeftPartOfCircle(const Edge& edge, PointId third) const;
  void SearchBox(const Edge& edge, const Box& box, const Box& done, PointId& best) const;
  void SearchRow(const Edge& edge, std::int64_t row, std::int64_t first, std::int64_t last, PointId& best) const;
  bool IsBetter(const Edge& edge, PointId candidate, PointId best) const;
  bool IsVisible(const Edge& edge, PointId candidate) const;

  const PlanePoint& At(PointId point) const { return this->Points[std::size_t(point)]; }

  const std::vector<PlanePoint>& Points;
  const CellGrid Grid;
  const PointLists PointsInCell;
  const HopLists HopsInCell;
};
}

#endif
