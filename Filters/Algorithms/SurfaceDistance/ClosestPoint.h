// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The distance from a point to a triangle.

#ifndef SeismicHorizonsClosestPoint_h
#define SeismicHorizonsClosestPoint_h

#include <Eigen/Core>

#include <algorithm>

namespace SeismicHorizons
{
/// The squared distance from `p` to the segment from `a` to `b`, which may be one point.
inline double SquaredDistanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double part = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - a - part * along).squaredNorm();
}

/// A triangle is a needle when the square of the sine of its angle at `a` is at most this. With 16 digits, the place on
/// its face that is nearest to a point is then no better than to 1e-16 / 1e-10 = 1e-6 of its size, while no place on
/// its face is more than about 1e-5 of its size away from a side.
constexpr double SquaredSineOfNeedle = 1e-10;

/// The squared distance from `p` to the triangle `a`, `b`, `c`, which may be without an area. The signs of scalar
/// products tell whether a corner, an edge or the face is nearest (Ericson 2005, "Real-Time Collision Detection",
/// 5.1.5). The result is always the distance to a point of the triangle, so that rounding can make it too large, but
/// never too small.
inline double SquaredDistanceToTriangle(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return ap.squaredNorm();
  }
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return bp.squaredNorm();
  }
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return cp.squaredNorm();
  }
  // With q for p projected onto the plane of the triangle: the signed area of a, b, q, times that of a, b, c, times 4;
  // likewise below.
  const double onC = d1 * d4 - d3 * d2;
  if (onC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, b);
  }
  const double onB = d5 * d2 - d1 * d6;
  if (onB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, c);
  }
  const double onA = d3 * d6 - d5 * d4;
  if (onA <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return SquaredDistanceToSegment(p, b, c);
  }
  const double sum = onA + onB + onC;
  const bool onFace = onA > 0.0 && onB > 0.0 && onC > 0.0;
  const double face = onFace ? (ap - onB / sum * ab - onC / sum * ac).squaredNorm() : 0.0;
  // On a needle q is rounded too much, but there a side is about as near. The sum is the square of the cross product of
  // ab and ac.
  if (onFace && sum > SquaredSineOfNeedle * ab.squaredNorm() * ac.squaredNorm())
  {
    return face;
  }
  const double side = std::min(
    { SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c), SquaredDistanceToSegment(p, c, a) });
  return onFace ? std::min(face, side) : side;
}
}

#endif
