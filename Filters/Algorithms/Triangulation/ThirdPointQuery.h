// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the search for the third point of an edge is about.

#ifndef SeismicHorizonsThirdPointQuery_h
#define SeismicHorizonsThirdPointQuery_h

#include "Common/Types.h"
#include "SearchGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace SeismicHorizons
{
/// A voxel that was looked into, for showing how the search works.
struct WalkedVoxel
{
  std::int64_t X = 0;
  std::int64_t Y = 0;
  /// 0 on the perpendicular bisector, n on its n-th dilatation, -1 beyond: in the box of the edge for Compactness, in
  /// squares around it, or in the circle of the candidate.
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

/// An edge, and how far the search for its third point is.
struct ThirdPointQuery
{
  ThirdPointQuery(const SearchGrid& points, PointId from, PointId to, std::vector<WalkedVoxel>* walk)
    : From(from)
    , To(to)
    , A(points.At(from))
    , B(points.At(to))
    , Walk(walk)
  {
  }

  PlanePoint DoubledMiddle() const { return { this->A.X + this->B.X, this->A.Y + this->B.Y }; }
  SegmentEnd Middle() const { return { 0.5 * this->DoubledMiddle().X, 0.5 * this->DoubledMiddle().Y }; }

  double SquaredLength() const
  {
    const double x = double(this->B.X) - this->A.X;
    const double y = double(this->B.Y) - this->A.Y;
    return x * x + y * y;
  }

  const PointId From;
  const PointId To;
  const PlanePoint A;
  const PlanePoint B;
  std::vector<WalkedVoxel>* const Walk;
  int Dilatation = -1; // of the voxels that are being looked into
  bool OnlyVisible = false;
  PointId Best = NoPoint;
  double BestCotangent = 0.0;
};

/// The square box of an edge, in voxels.
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
  const std::int64_t Size; // of the edge: the thesis's k
};

/// The circle of the points to the left that see an edge at an angle of some cotangent, as seen from the start of the
/// edge. Plain doubles, and a margin by which their rounding makes it uncertain.
struct EdgeCircle
{
  EdgeCircle(const ThirdPointQuery& query, double cotangent)
    : EdgeCircle(query, cotangent, 0.5 * std::sqrt((1.0 + cotangent * cotangent) * query.SquaredLength()))
  {
  }

  /// For a radius that is known already.
  EdgeCircle(const ThirdPointQuery& query, double cotangent, double radius)
    : Start(query.A)
    , EdgeX(double(query.B.X) - query.A.X)
    , EdgeY(double(query.B.Y) - query.A.Y)
    , X(0.5 * (this->EdgeX - this->EdgeY * cotangent))
    , Y(0.5 * (this->EdgeY + this->EdgeX * cotangent))
    , Radius(radius)
    , Margin(1e-6 + 1e-12 * this->Radius)
    , Reach((this->Radius + this->Margin) * (this->Radius + this->Margin))
  {
  }

  /// False only when the point is for certain outside or to the right of the edge. No branches that a processor would
  /// have to guess.
  bool MayHold(const PlanePoint& point) const
  {
    const double x = double(point.X - this->Start.X);
    const double y = double(point.Y - this->Start.Y);
    const double fromX = x - this->X;
    const double fromY = y - this->Y;
    // Rounding leaves the two products in their order, or makes them equal.
    return (fromX * fromX + fromY * fromY <= this->Reach) & (this->EdgeX * y >= this->EdgeY * x);
  }

  /// False only when no place of a box is inside, left or right of the edge.
  bool MayReach(const PlanePoint& low, const PlanePoint& high) const
  {
    const double x = this->X + this->Start.X;
    const double y = this->Y + this->Start.Y;
    const double byX = std::max({ low.X - x, 0.0, x - high.X });
    const double byY = std::max({ low.Y - y, 0.0, y - high.Y });
    return byX * byX + byY * byY <= this->Reach;
  }

  PlanePoint Start;
  double EdgeX;
  double EdgeY;
  double X;
  double Y;
  double Radius;
  double Margin;
  double Reach; // squared
};
}

#endif
