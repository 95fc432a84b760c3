// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Third point of a triangle on an edge (thesis 5.3.4 to 5.3.6 and 5.4): of the visible points to its left, the one
// whose circumcircle with the edge has no other such point inside. The steps are declared here for tests.

#ifndef SeismicHorizonsThirdPointSearch_h
#define SeismicHorizonsThirdPointSearch_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"
#include "SearchGrid.h"
#include "Triangulation.h"

#include <memory>
#include <mutex>
#include <vector>

namespace SeismicHorizons
{
struct WalkedCell
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  /// This is 0 on the perpendicular bisector, n on the n-th dilatation, and -1 in other steps.
  int Dilatation = 0;
};

struct ThirdPointQuery
{
  ThirdPointQuery(const SearchGrid& points, PointId from, PointId to, std::vector<WalkedCell>* walk)
    : Points(points)
    , A(points.At(from))
    , B(points.At(to))
    , Walk(walk)
  {
  }

  PlanePoint DoubledMiddle() const { return { this->A.X + this->B.X, this->A.Y + this->B.Y }; }
  SegmentEnd Middle() const { return { 0.5 * this->DoubledMiddle().X, 0.5 * this->DoubledMiddle().Y }; }

  double SquaredLength() const { return double(SquaredDistance(this->A, this->B)); }

  /// Takes a point to the left if it is better than the best so far, and visible if OnlyVisible is set.
  void Consider(PointId candidate);

  /// `area` is the doubled area of the triangle with the edge.
  void Take(PointId point, std::int64_t area);

  /// A point is visible if no boundary edge crosses the segment from the middle of the edge to it.
  bool IsVisible(PointId point) const;

  const SearchGrid& Points;
  const PlanePoint A;
  const PlanePoint B;
  std::vector<WalkedCell>* const Walk; // receives visited cells, if not null
  int Dilatation = -1;
  bool OnlyVisible = false;
  PointId Best = NoPoint;
  double BestCotangent = 0.0; // of the angle at which Best sees the edge

private:
  double CotangentOf(const PlanePoint& place, std::int64_t area) const;
  bool IsBetter(const PlanePoint& place, PointId candidate, double cotangent) const;
};

struct CellBox
{
  std::int64_t FirstX;
  std::int64_t FirstY;
  std::int64_t LastX;
  std::int64_t LastY;
};

/// Returns the cells that the segment of the circle to the left of the edge may touch.
CellBox CellsOfCircle(const ThirdPointQuery& query, float cotangent, float radius);

CellBox CellsOfBest(const ThirdPointQuery& query);

/// The box must contain the edge. If a point has a cotangent within `bound`, the best one is considered; otherwise any
/// or none. With OnlyVisible, all points within the bound are considered.
void ScanBox(ThirdPointQuery& query, const CellBox& box, float bound);

struct ThirdPoint
{
  PointId Point = NoPoint;
  float Diameter = 0.0f; // of the circumcircle
};

class ThirdPointSearch
{
public:
  ThirdPointSearch(const SearchGrid& points, SearchStrategy strategy);

  /// `neighbor` is the approximate diameter of the circumcircle of the adjacent triangle, or 0, and sets where to
  /// start. With a walk, the search follows the strategy alone.
  ThirdPoint Find(PointId a, PointId b, float neighbor, std::vector<WalkedCell>* walk = nullptr) const;

  /// The edge is Delaunay without constraints, too, if a circle through its ends holds no point, visible or not. A
  /// point must be to the left.
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
  mutable std::unique_ptr<PointPyramid> Pyramid;
};
}

#endif
