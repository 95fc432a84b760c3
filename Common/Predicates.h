// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The questions of plane geometry that decide how a mesh is connected. All answers are exact for coordinates below
// 2^29 in size (PlanePoint): signed areas fit 64 bits, and in-circle determinants 128.

#ifndef SeismicHorizonsPredicates_h
#define SeismicHorizonsPredicates_h

#include "PlaneGeometry.h"
#include "Portable.h"
#include "Types.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
/// Twice the signed area of the triangle a, b, c: positive when it turns counter-clockwise.
inline std::int64_t SignedArea(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const std::int64_t bx = std::int64_t(b.X) - a.X;
  const std::int64_t by = std::int64_t(b.Y) - a.Y;
  const std::int64_t cx = std::int64_t(c.X) - a.X;
  const std::int64_t cy = std::int64_t(c.Y) - a.Y;
  return bx * cy - by * cx;
}

/// Of the smallest angle of a triangle, which is between its two longer sides; at most 0 when it is flat or clockwise.
/// Rounded, unlike the answers of all others here.
inline double SineOfSmallestAngle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const double ab = double(SquaredDistance(a, b));
  const double bc = double(SquaredDistance(b, c));
  const double ca = double(SquaredDistance(c, a));
  const double longer = std::max({ ab * bc, bc * ca, ca * ab });
  return longer > 0.0 ? double(SignedArea(a, b, c)) / std::sqrt(longer) : 0.0;
}

/// Of an angle in degrees.
inline double SineOfDegrees(double angle)
{
  return std::sin(angle * std::atan(1.0) / 45.0);
}

/// -1, 0 or 1.
template <typename Number>
int Sign(Number value)
{
  return int(value > 0) - int(value < 0);
}

/// True when the segments a-b and c-d cross in one point that is an end of neither.
inline bool ProperlyCross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return Sign(SignedArea(a, b, c)) * Sign(SignedArea(a, b, d)) < 0 &&
    Sign(SignedArea(c, d, a)) * Sign(SignedArea(c, d, b)) < 0;
}

/// True when p lies on the segment a-b and is none of its ends.
inline bool OnOpenSegment(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return SignedArea(a, b, p) == 0 && ScalarProduct(p, a, b) < 0;
}

/// Positive when d lies inside the circle through a, b, c, which must turn counter-clockwise; negative when outside;
/// never 0 when the four are the corners of a convex quadrangle.
///
/// On a lattice four points on one circle are the rule, and a triangulation has to cut all such quadrangles in ways
/// that fit together. Circles here are therefore those of the metric x^2 + y^2 + e x y + e^2 x^2 with an infinitely
/// small e > 0, so that the mesh is the Delaunay triangulation of points that are sheared by infinitely little. Only a
/// quadrangle with parallel diagonals could leave all three terms of the metric undecided, and those of a convex one
/// cross. The answer depends on the places of the points alone: not on their order, nor on the search that finds them,
/// nor on where the origin is.
int InCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);
}

#endif
