// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The distance from a point to a triangle.

#ifndef SeismicHorizonsClosestPoint_h
#define SeismicHorizonsClosestPoint_h

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/// A triangle is a needle when twice its area is at most the square root of this part of the square of a long side at
/// `a`: it is a hundred times as long as it is wide. Differences of products of four lengths then lose 4 of 16 digits.
constexpr double SquaredWidthOfNeedle = 1e-4;

/// The squared distance from `p` to the triangle `a`, `b`, `c` when no corner is nearest, by cross products: of a
/// needle they lose half as many digits as the differences of scalar products do. For a triangle without an area all
/// sides are tried.
inline double SquaredDistanceToNeedle(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // The cross product is wrong by a part of the product of two long sides, and its distance to p by that times the
  // length unless it is at right angles to the longest side.
  const Eigen::Vector3d sides[3] = { b - a, c - b, a - c };
  const Eigen::Vector3d& longest = *std::max_element(
    sides, sides + 3, [](const auto& one, const auto& other) { return one.squaredNorm() < other.squaredNorm(); });
  Eigen::Vector3d normal = sides[0].cross(-sides[2]);
  normal -= longest.squaredNorm() > 0.0 ? Eigen::Vector3d(normal.dot(longest) / longest.squaredNorm() * longest)
                                        : Eigen::Vector3d::Zero();
  const double square = normal.squaredNorm();
  const auto isLeft = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  { return normal.dot((to - from).cross(p - from)) > 0.0; };
  if (square > 0.0 && isLeft(a, b) && isLeft(b, c) && isLeft(c, a))
  {
    const double distance = normal.dot(p - a);
    return distance * distance / square;
  }
  return std::min(
    { SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c), SquaredDistanceToSegment(p, c, a) });
}

/// The squared distance from `p` to the triangle `a`, `b`, `c`, which may be without an area. The signs of scalar
/// products tell whether a corner, an edge or the face is nearest (Ericson 2005, "Real-Time Collision Detection",
/// 5.1.5).
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
  // likewise below. The sum is the square of the cross product of ab and ac, whose squares are d1 - d3 and d2 - d6.
  const double onC = d1 * d4 - d3 * d2;
  const double onB = d5 * d2 - d1 * d6;
  const double onA = d3 * d6 - d5 * d4;
  const double sum = onA + onB + onC;
  const double longer = std::max(d1 - d3, d2 - d6);
  if (!(sum > SquaredWidthOfNeedle * longer * longer))
  {
    return SquaredDistanceToNeedle(p, a, b, c);
  }
  if (onC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, b);
  }
  if (onB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return SquaredDistanceToSegment(p, a, c);
  }
  if (onA <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return SquaredDistanceToSegment(p, b, c);
  }
  return (ap - onB / sum * ab - onC / sum * ac).squaredNorm();
}
}

#endif
