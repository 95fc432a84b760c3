// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle mesh of any origin, as plain data.

#ifndef SeismicHorizonsTriangleSurface_h
#define SeismicHorizonsTriangleSurface_h

#include "Common/Types.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace SeismicHorizons
{
using Corners = std::array<PointId, 3>;

/// Triangles may have any shape and orientation; they may also be without an area. Points that are the corner of no
/// triangle are no part of the surface. Points are given relative to a place near them, so that their differences are
/// exact.
struct TriangleSurface
{
  std::vector<Eigen::Vector3d> Points;
  std::vector<Corners> Triangles;
  /// By point: 1 where figures leave it out, and the triangles at it. Distances are measured to these as to all others.
  /// Empty when all count.
  std::vector<unsigned char> LeftOut;

  const Eigen::Vector3d& Point(PointId point) const { return this->Points[std::size_t(point)]; }

  bool Counts(PointId point) const { return this->LeftOut.empty() || this->LeftOut[std::size_t(point)] == 0; }
  bool Counts(const Corners& t) const { return this->Counts(t[0]) && this->Counts(t[1]) && this->Counts(t[2]); }

  double Area(const Corners& t) const
  {
    return 0.5 * (this->Point(t[1]) - this->Point(t[0])).cross(this->Point(t[2]) - this->Point(t[0])).norm();
  }
};

/// Squares of larger coordinates would leave the range of single precision, which searches use.
constexpr double LargestCoordinate = 1e16;

/// Throws InputError on a surface without triangles, without any area that counts, with a corner that is no point of
/// it, and on coordinates that are not finite or larger than LargestCoordinate. Messages begin with `name`.
void CheckSurface(const TriangleSurface& surface, const char* name);

/// The diagonal of the bounding box of all triangles.
double MeasureDiagonal(const TriangleSurface& surface);
}

#endif
