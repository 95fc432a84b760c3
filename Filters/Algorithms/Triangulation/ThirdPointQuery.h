// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search for the third point of one edge: the edge, the best point so far, and the box and the circle to look in.

#ifndef SeismicHorizonsThirdPointQuery_h
#define SeismicHorizonsThirdPointQuery_h

#include "Common/PlaneGeometry.h"
#include "Common/Types.h"
#include "SearchGrid.h"

#include <algorithm>
#include <cmath>
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

/// A block of voxels, the last row and column included.
struct VoxelBox
{
  std::int64_t FirstX;
  std::int64_t FirstY;
  std::int64_t LastX;
  std::int64_t LastY;
};

/// From a place to the nearest place of a box.
inline double SquaredDistanceToBox(const SegmentEnd& place, const PlaneBox& box)
{
  const double x = std::max({ box.Least.X - place.X, 0.0, place.X - box.Greatest.X });
  const double y = std::max({ box.Least.Y - place.Y, 0.0, place.Y - box.Greatest.Y });
  return x * x + y * y;
}

/// An edge from A to B, and the best point that was found for it so far.
struct ThirdPointQuery
{
  /// Keeps a reference to the points.
  ThirdPointQuery(const SearchGrid& points, PointId from, PointId to, std::vector<WalkedVoxel>* walk)
    : Points(points)
    , From(from)
    , To(to)
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
  const PointId From;
  const PointId To;
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

/// The square box of an edge (thesis 5.3.2), in voxels: as far around its middle as it is long.
struct EdgeBox
{
  EdgeBox(const ThirdPointQuery& query, const CellGrid& grid)
    : MiddleX(grid.InCellsX(query.Middle().X))
    , MiddleY(grid.InCellsY(query.Middle().Y))
    , Size(std::max({ std::int64_t(1), std::abs(grid.CellX(query.A.X) - grid.CellX(query.B.X)),
        std::abs(grid.CellY(query.A.Y) - grid.CellY(query.B.Y)) }))
  {
  }

  const double MiddleX;
  const double MiddleY;
  const std::int64_t Size; // the longer one of the edge's two extents: the thesis's k
};

// The centre and the radius of a circle are right to some units in the last place, 10^-16 of their size, and
// coordinates, which are below 2^30, to 10^-6. What is farther outside than this is outside for certain.
constexpr double CircleMargin = 1e-6;
constexpr double CircleMarginPerRadius = 1e-12;

/// The circle of the points to the left of an edge that see it at an angle with some cotangent, in coordinates from the
/// start of the edge. In plain doubles: a point within the margin may be inside or outside.
struct EdgeCircle
{
  EdgeCircle(const ThirdPointQuery& query, double cotangent)
    : Start(query.A)
    , EdgeX(double(query.B.X) - query.A.X)
    , EdgeY(double(query.B.Y) - query.A.Y)
    , X(0.5 * (this->EdgeX - this->EdgeY * cotangent))
    , Y(0.5 * (this->EdgeY + this->EdgeX * cotangent))
  {
    const double radius = 0.5 * std::sqrt((1.0 + cotangent * cotangent) * query.SquaredLength());
    const double reach = radius + CircleMargin + CircleMarginPerRadius * radius;
    this->SquaredReach = reach * reach;
  }

  /// False only when the point is for certain outside, or to the right of the edge. Without branches: points are inside
  /// or outside in no order that a processor could predict.
  bool MayHold(const PlanePoint& point) const
  {
    const double x = double(point.X - this->Start.X);
    const double y = double(point.Y - this->Start.Y);
    const double fromX = x - this->X;
    const double fromY = y - this->Y;
    // Rounding keeps the order of the two products, or makes them equal.
    return (fromX * fromX + fromY * fromY <= this->SquaredReach) & (this->EdgeX * y >= this->EdgeY * x);
  }

  /// False only when no place of a box is inside, left or right of the edge.
  bool MayReach(const PlaneBox& box) const
  {
    return SquaredDistanceToBox({ this->X + this->Start.X, this->Y + this->Start.Y }, box) <= this->SquaredReach;
  }

  PlanePoint Start;
  double EdgeX; // the vector of the edge
  double EdgeY;
  double X; // the centre
  double Y;
  double SquaredReach; // of the radius and the margin
};
}

#endif
