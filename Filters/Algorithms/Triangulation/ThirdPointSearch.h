// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point that makes a triangle with an edge (thesis 5.3.4 to 5.3.6 and 5.4): of all points to the left of the edge
// that can be seen from it, the one whose circle with the edge has no other such point inside. Tests look at the steps
// of the search, which is why they are here.

#ifndef SeismicHorizonsThirdPointSearch_h
#define SeismicHorizonsThirdPointSearch_h

#include "Common/PlaneGeometry.h"
#include "Common/Types.h"
#include "SearchGrid.h"
#include "Triangulation.h"

#include <memory>
#include <mutex>
#include <vector>

namespace SeismicHorizons
{
/// A voxel that was looked into, to show how the search works.
struct WalkedVoxel
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  /// 0 on the perpendicular bisector, n on its n-th dilatation, -1 where neither led there: in the box of the edge for
  /// Compactness, in squares around it, or in the circle of the candidate.
  int Dilatation = 0;
};

/// An edge from A to B, and the best point that was found for it so far.
struct ThirdPointQuery
{
  /// Keeps a reference to the points.
  ThirdPointQuery(const SearchGrid& points, PointId from, PointId to, std::vector<WalkedVoxel>* walk)
    : Points(points)
    , A(points.At(from))
    , B(points.At(to))
    , Walk(walk)
  {
  }

  PlanePoint DoubledMiddle() const { return { this->A.X + this->B.X, this->A.Y + this->B.Y }; }
  SegmentEnd Middle() const { return { 0.5 * this->DoubledMiddle().X, 0.5 * this->DoubledMiddle().Y }; }

  double SquaredLength() const { return double(SquaredDistance(this->A, this->B)); }

  /// Takes a point as the best if it is better than the best so far, to the left of the edge, and visible where only
  /// such points count.
  void Consider(PointId candidate);

  /// Takes a point to the left of the edge as the best; `area` is twice that of its triangle with the edge.
  void Take(PointId point, std::int64_t area);

  /// Whether the segment from the middle of the edge to a point crosses no boundary edge.
  bool IsVisible(PointId point) const;

  const SearchGrid& Points;
  const PlanePoint A;
  const PlanePoint B;
  std::vector<WalkedVoxel>* const Walk; // takes the voxels that are looked into, if not null
  int Dilatation = -1; // of the voxels that are being looked into
  bool OnlyVisible = false; // whether points behind boundary edges do not count
  PointId Best = NoPoint;
  double BestCotangent = 0.0; // of the angle at which the best point sees the edge

private:
  double CotangentOf(const PlanePoint& place, std::int64_t area) const;
  bool IsBetter(const PlanePoint& place, PointId candidate, double cotangent) const;
};

/// A block of voxels, the last row and column included.
struct VoxelBox
{
  std::int64_t FirstX;
  std::int64_t FirstY;
  std::int64_t LastX;
  std::int64_t LastY;
};

/// The voxels that the part of a circle to the left of an edge may touch. The circle is that of the points to the left
/// from which the edge is seen at an angle with some cotangent; `radius` is its own.
VoxelBox VoxelsOfCircle(const ThirdPointQuery& query, float cotangent, float radius);

/// The same for the circle of the best point so far.
VoxelBox VoxelsOfBest(const ThirdPointQuery& query);

/// Lets the query consider those of the points in a box, in which the edge has to be, that may be the third point, as
/// long as there is one whose cotangent is not above the bound; else perhaps others, or none. When only visible points
/// count, these are all up to the bound.
void ScanBox(ThirdPointQuery& query, const VoxelBox& box, float bound);

struct ThirdPoint
{
  PointId Point = NoPoint; // none when nothing can be seen to the left of the edge
  float Diameter = 0.0f; // of its circle with the edge
};

class ThirdPointSearch
{
public:
  /// `points` must outlive the search; edges are asked for by its numbers.
  ThirdPointSearch(const SearchGrid& points, SearchStrategy strategy);

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
  void SearchFar(ThirdPointQuery& query) const;

  const SearchStrategy Strategy;
  const SearchGrid& Points;
  const float UsualHeight;
  const float GreatestHeight;
  mutable std::once_flag PyramidFlag;
  mutable std::unique_ptr<PointPyramid> Pyramid; // made when it is first needed
};
}

#endif
