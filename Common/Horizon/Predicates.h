// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact geometric predicates for coordinates below 2^29 (PlanePoint): signed areas fit 64 bits, and in-circle
// determinants 128.
//
// On a lattice many quadrangles are cocircular, and diagonals must be consistent. Circles of InCircle are therefore of
// the metric x^2 + y^2 + e x y + e^2 x^2 with infinitesimal e > 0, which gives the Delaunay triangulation of
// infinitesimally sheared points. Only parallel diagonals could leave all three terms undecided, and diagonals of a
// convex quadrangle cross. The answer depends on positions alone, not on the order of points, the search, or the
// origin.

#ifndef SeismicHorizonsPredicates_h
#define SeismicHorizonsPredicates_h

#include "Common/Base/Portable.h"
#include "PlaneGeometry.h"
#include "Types.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
inline std::int64_t SignedArea(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const std::int64_t bx = std::int64_t(b.X) - a.X;
  const std::int64_t by = std::int64_t(b.Y) - a.Y;
  const std::int64_t cx = std::int64_t(c.X) - a.X;
  const std::int64_t cy = std::int64_t(c.Y) - a.Y;
  return bx * cy - by * cx;
}

/// The smallest angle is between the two longer sides. The result is at most 0 for flat and clockwise triangles, and
/// rounded, unlike the predicates.
inline double SineOfSmallestAngle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const double ab = double(SquaredDistance(a, b));
  const double bc = double(SquaredDistance(b, c));
  const double ca = double(SquaredDistance(c, a));
  const double longer = std::max({ ab * bc, bc * ca, ca * ab });
  return longer > 0.0 ? double(SignedArea(a, b, c)) / std::sqrt(longer) : 0.0;
}

inline double SineOfDegrees(double angle)
{
  return std::sin(angle * std::atan(1.0) / 45.0);
}

template <typename Number>
int Sign(Number value)
{
  return int(value > 0) - int(value < 0);
}

/// The common point must be inside both segments.
inline bool ProperlyCross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return Sign(SignedArea(a, b, c)) * Sign(SignedArea(a, b, d)) < 0 &&
    Sign(SignedArea(c, d, a)) * Sign(SignedArea(c, d, b)) < 0;
}

inline bool OnOpenSegment(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return SignedArea(a, b, p) == 0 && ScalarProduct(p, a, b) < 0;
}

/// Positive if d is inside the circle through a, b and c, which must be counterclockwise, and negative if it is
/// outside; never 0 for the corners of a convex quadrangle.
int InCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);
}

#endif
