// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point that makes a triangle with an edge (thesis 5.3.4 to 5.3.6 and 5.4): of all points to the left of the edge
// that can be seen from it, the one whose circle with the edge has no other such point inside.
//
// Points are looked up in a grid of square voxels with about one point each. A first candidate is found by one of two
// strategies in the square box of the edge, which is as far around its middle as the edge is long.
//
// VoxelTraversal looks into the voxels along the perpendicular bisector, from the middle of the edge, and then into
// those of its dilatations, until it finds a point. The n-th dilatation is the bisector's line of voxels moved by n to
// either side, along the axis on which the line advances less (5.3.6.2):
//
//      1 0 1 2 . . .
//      1 0 1 2 . . .        a-b    the edge, from a to b: its left is above
//      2 1 0 1 2 . .        0      the perpendicular bisector
//      2 1 0 1 2 . .        1      the first dilatation, both lines of it
//      2 1 0 1 2 . .        2      the second one
//      . 2 1 0 1 2 b
//      . 2 1 0 1 2 .
//      a . . . . . .
//
// Most often the point is in the voxel beside the edge. So before all this a circle through a and b is searched, the
// part of it to the left of the edge: one as large as the circle of the triangle on the other side of the edge
// suggests, which is empty, or little higher than points are apart. When it has points, the third point is one of them.
//
// Compactness takes that point of the box which makes the most compact triangle (eq. 5.9).
//
// When the box has no point, or is so large that going through it takes long, boxes of points are searched, from near
// to far (PointPyramid.h). Whatever the candidate in the box of the edge, the circle through it and the edge is then
// searched for better points (the Delaunay criterion, Alg. 5.1), so that both strategies end with the same point:
//
//           . c .             a-b    the edge, from a to b
//        .         .          c      the candidate
//      .       d     .        d      a better point: inside the circle, from where the edge is seen at a larger angle
//     .               .              than from c
//     .               .
//     .               .       Searched are the voxels that the part of the circle to the left of the edge may touch. Of
//      a-------------b        the points in it, that which sees the edge at the largest angle is the third point: its
//        .         .          own circle has none in the part to the left.
//           . . .
//
// With constraints, a point counts only when the segment from the middle of the edge to it crosses no boundary edge.
// Looking from the middle is enough: the third point is seen from every place on the edge, and a point of the circle
// that is seen from the middle would be seen from inside the triangle as well, which a constrained Delaunay triangle
// excludes. As few edges have a boundary edge near, the best of all points is looked for first, seen or not; if it is
// seen, it is the third point.

#ifndef SeismicHorizonsThirdPointSearch_h
#define SeismicHorizonsThirdPointSearch_h

#include "Common/Types.h"
#include "PointPyramid.h"
#include "SearchGrid.h"
#include "ThirdPointQuery.h"

#include <memory>
#include <mutex>
#include <vector>

namespace SeismicHorizons
{
enum class SearchStrategy
{
  VoxelTraversal,
  Compactness
};

struct ThirdPoint
{
  PointId Point = NoPoint; // none when nothing can be seen to the left of the edge
  float Diameter = 0.0f; // of its circle with the edge
};

class ThirdPointSearch
{
public:
  /// `grid` must outlive the search; edges are asked for by its numbers.
  ThirdPointSearch(const SearchGrid& grid, SearchStrategy strategy);

  /// The third point for the edge from a to b. `neighbor` is about the diameter of the circle of the triangle on the
  /// other side of the edge, 0 where that is not known: it says where to look first. `walk`, when given, takes the
  /// voxels that were looked into, in their order; the circle that comes first otherwise is left out then, so that they
  /// show the strategy.
  ThirdPoint Find(PointId a, PointId b, float neighbor, std::vector<WalkedVoxel>* walk = nullptr) const;

  /// Whether there is a circle through the ends of an edge that holds no point, seen from the edge or not: then it is
  /// an edge of the Delaunay triangulation without constraints, too. There must be a point to the left of it.
  bool IsDelaunay(PointId a, PointId b) const;

private:
  void Search(ThirdPointQuery& query, float height) const;
  bool SearchNearby(ThirdPointQuery& query, float height) const;
  float FirstHeight(float neighbor) const;
  void TraverseBox(ThirdPointQuery& query, const EdgeBox& edgeBox) const;
  void SearchDilatation(ThirdPointQuery& query, const EdgeBox& edgeBox, std::int64_t shift) const;
  void CompareBox(ThirdPointQuery& query, const EdgeBox& edgeBox) const;
  void SearchSquares(ThirdPointQuery& query, const EdgeBox& edgeBox) const;
  void SearchFar(ThirdPointQuery& query) const;

  VoxelBox SquareAround(const EdgeBox& edgeBox, std::int64_t radius) const;
  void ScanBox(ThirdPointQuery& query, const VoxelBox& box, float bound) const;
  void SearchBox(ThirdPointQuery& query, const VoxelBox& box) const;
  void SearchRow(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last) const;
  void Trace(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last) const;
  template <typename Visitor>
  void VisitRow(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last, Visitor&& visit) const;

  const PlanePoint& At(PointId point) const { return this->Points.At(point); }

  const SearchStrategy Strategy;
  const SearchGrid& Points;
  const CellGrid& Grid;
  const float UsualHeight;
  const float GreatestHeight;
  mutable std::once_flag PyramidFlag;
  mutable std::unique_ptr<PointPyramid> Pyramid; // made when it is first needed
};
}

#endif
