// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point that makes a triangle with an edge (thesis 5.3.4 to 5.3.6 and 5.4): of all points to the left of the edge
// that can be seen from it, the one whose circle with the edge is empty.
//
// Points are looked up in a grid of square voxels with about one point each. A first candidate is found by one of two
// strategies in the square box of the edge, which is as far around its middle as the edge is long:
//  - VoxelTraversal: along the perpendicular bisector from the middle of the edge, then along its dilatations, one
//  voxel
//    further to both sides each time, until there is a point;
//  - Compactness: of all points in the box the one that makes the most compact triangle (eq. 5.9).
// When the box has none, growing squares are searched. Then what the circle of the candidate covers is searched for
// better points (the Delaunay criterion, Alg. 5.1). As that is exact, both strategies end with the same point.
//
// With constraints, a point counts only when the segment from the middle of the edge to it crosses none. Looking from
// the middle is enough: the third point is seen from every place on the edge, and a point of the circle that is seen
// from the middle would be seen from inside the triangle as well, which a constrained Delaunay triangle excludes. As
// few edges have a constraint near, the best of all points is looked for first, seen or not; if it is seen, it is best.

#ifndef SeismicHorizonsThirdPointSearch_h
#define SeismicHorizonsThirdPointSearch_h

#include "CellGrid.h"
#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
enum class SearchStrategy
{
  VoxelTraversal,
  Compactness
};

/// A voxel that was looked into, for showing how the search works.
struct WalkedVoxel
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  /// 0 on the perpendicular bisector, n on its n-th dilatation, -1 beyond: in the box of the edge for Compactness, in
  /// squares around it, or in the circle of the candidate.
  int Dilatation = 0;
};

class ThirdPointSearch
{
public:
  /// Coordinates are at least 0 and below 2^29. The search gives the points numbers of its own, voxel by voxel; the
  /// edges it is asked for use these. Throws InputError when two points are in one place, a point lies on a boundary
  /// edge, or two boundary edges cross; `names` gives the numbers by which messages call the points.
  ThirdPointSearch(const std::vector<PlanePoint>& points, const Loops& boundary, const std::vector<PointId>& names,
    SearchStrategy strategy);

  /// The number the search gave to a point, and the name of the point with such a number.
  PointId NumberOf(PointId point) const { return this->Sorted.Numbers[std::size_t(point)]; }
  PointId NameOf(PointId number) const { return this->Sorted.Names[std::size_t(number)]; }

  /// The third point for the edge from a to b, or NoPoint when nothing can be seen to the left of it. `walk`, when
  /// given, takes the voxels that were looked into, in their order.
  PointId Find(PointId a, PointId b, std::vector<WalkedVoxel>* walk = nullptr) const;

  /// Whether there is a circle through the ends of an edge that holds no point, seen from the edge or not: then it
  /// would be an edge of the triangulation without being asked for. There must be a point to the left of it.
  bool IsDelaunay(PointId a, PointId b) const;

  /// The grid of voxels.
  const CellGrid& GetVoxels() const { return this->Grid; }

private:
  struct Box;
  struct Circle;
  struct Task;

  /// The points in the order of the search.
  struct SortedPoints
  {
    SortedPoints(const CellGrid& grid, const std::vector<PlanePoint>& points, const std::vector<PointId>& names);

    std::vector<PlanePoint> Places; // voxel by voxel
    std::vector<PointId> Names; // the same
    std::vector<PointId> Starts; // for each voxel its first point
    std::vector<PointId> Numbers; // by the numbers that points had before
  };

  void CheckPlaces() const;
  void CheckEdges() const;

  void TraverseBox(Task& task) const;
  void SearchDilatation(Task& task, std::int64_t shift) const;
  void CompareBox(Task& task) const;
  void SearchSquares(Task& task) const;

  Box SquareAround(const Task& task, std::int64_t radius) const;
  Box LeftPartOf(const Circle& circle, const Task& task) const;
  void SearchCircle(Task& task) const;
  void SearchBox(Task& task, const Box& box) const;
  void SearchRow(Task& task, std::int64_t row, std::int64_t first, std::int64_t last) const;
  template <typename Visitor>
  void VisitRow(Task& task, std::int64_t row, std::int64_t first, std::int64_t last, Visitor&& visit) const;

  void Search(Task& task) const;
  void Consider(Task& task, PointId candidate) const;
  bool IsBetter(const Task& task, PointId candidate, double cotangent) const;
  bool HasHops(const SegmentEnd& from, const SegmentEnd& to) const;
  bool IsVisible(const Task& task, PointId candidate) const;

  const PlanePoint& At(PointId point) const { return this->Sorted.Places[std::size_t(point)]; }
  PointId FirstIn(std::int64_t cell) const { return this->Sorted.Starts[std::size_t(cell)]; }
  PointId EndOf(std::int64_t cell) const { return this->Sorted.Starts[std::size_t(cell) + 1]; }

  const SearchStrategy Strategy;
  const CellGrid Grid;
  const SortedPoints Sorted;
  const HopLists HopsInCell;
};
}

#endif
