// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances from a place to a triangle can be measured on the lattice or in the world, which a linear map relates. One
// search structure serves both.

#ifndef SeismicHorizonsMetric_h
#define SeismicHorizonsMetric_h

#include "TriangleSurface.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
/// The segment may be a point.
inline double SquaredDistanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double fraction = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - a - fraction * along).squaredNorm();
}

/// The squared doubled area of a needle is at most this fraction of the fourth power of the longer edge at `a`. It is a
/// hundred times longer than wide: differences of products of four lengths lose 4 of 16 digits.
constexpr double SquaredWidthOfNeedle = 1e-4;

/// No corner may be nearest. Cross products lose half as many digits of needles as scalar products.
inline double SquaredDistanceToNeedle(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // Rounding of the cross product along the longest edge would be multiplied by the distance, so it is removed.
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

/// Signs of scalar products show whether a corner, an edge or the face is nearest (Ericson 2005, "Real-Time Collision
/// Detection", 5.1.5).
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
  // With q the projection of p, onC is four times the signed area of a, b, q, times the signed area of a, b, c, and so
  // on. The sum is the squared cross product of ab and ac.
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

/// Rotations and reflections keep distances, so a triangular matrix serves for any map: x to (Plan(0, 0) x, 0), y to
/// (Plan(0, 1), Plan(1, 1)) y, z to Vertical z.
class Metric
{
public:
  Metric() = default;

  /// Neither map may be singular.
  Metric(const Eigen::Matrix2d& plan, double vertical)
    : XtoX(plan.col(0).norm())
    , YtoX(plan.col(0).dot(plan.col(1)) / this->XtoX)
    , YtoY(std::abs(plan.determinant()) / this->XtoX)
    , ZtoZ(std::abs(vertical))
  {
    // With c for the cosine between the images of x and y, |image|^2 >= (1 - |c|) (|x image|^2 + |y image|^2).
    const double yLength = plan.col(1).norm();
    const double least = std::sqrt(std::max(0.0, 1.0 - std::abs(this->YtoX) / yLength));
    this->AxisWeights = { least * this->XtoX, least * yLength, this->ZtoZ };
    this->Shrinkage = 1.0 / (this->XtoX * this->YtoY * this->XtoX * this->YtoY);
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const
  {
    return { this->XtoX * v.x() + this->YtoX * v.y(), this->YtoY * v.y(), this->ZtoZ * v.z() };
  }

  Eigen::Vector3d Transposed(const Eigen::Vector3d& v) const
  {
    return { this->XtoX * v.x(), this->YtoX * v.x() + this->YtoY * v.y(), this->ZtoZ * v.z() };
  }

  /// Differences are at least as long as their coordinates times these weights.
  const Eigen::Array3d& Weights() const { return this->AxisWeights; }

  /// Returns the squared ratio of an area in plan to the area of its image.
  double SquaredPlanShrinkage() const { return this->Shrinkage; }

  /// Returns the square of the largest stretch of a difference in plan.
  double SquaredPlanNorm() const { return this->XtoX * this->XtoX + this->YtoX * this->YtoX + this->YtoY * this->YtoY; }

  double Length(const Eigen::Vector3d& v) const { return (*this)(v).norm(); }

  double Area(const TriangleSurface& surface, const Corners& t) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return 0.5 * (*this)(surface.Point(t[1]) - a).cross((*this)(surface.Point(t[2]) - a)).norm();
  }

  double SquaredDistance(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return SquaredDistanceToTriangle(
      (*this)(place - a), Eigen::Vector3d::Zero(), (*this)(surface.Point(t[1]) - a), (*this)(surface.Point(t[2]) - a));
  }

  /// Never exceeds SquaredDistance().
  double SquaredDistanceToBox(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    const Eigen::Vector3d& b = surface.Point(t[1]);
    const Eigen::Vector3d& c = surface.Point(t[2]);
    // Vectorized by two coordinates.
    const auto plan = [](const Eigen::Vector3d& v) { return v.head<2>().array(); };
    const Eigen::Array2d low = plan(a).min(plan(b)).min(plan(c)) - plan(place);
    const Eigen::Array2d high = plan(place) - plan(a).max(plan(b)).max(plan(c));
    const Eigen::Array2d gap = low.max(high).max(0.0) * this->AxisWeights.head<2>();
    const double below = std::min(std::min(a.z(), b.z()), c.z()) - place.z();
    const double above = place.z() - std::max(std::max(a.z(), b.z()), c.z());
    const double height = std::max(std::max(below, above), 0.0) * this->AxisWeights[2];
    return gap.square().sum() + height * height;
  }

private:
  double XtoX = 1.0;
  double YtoX = 0.0;
  double YtoY = 1.0;
  double ZtoZ = 1.0;
  double Shrinkage = 1.0;
  Eigen::Array3d AxisWeights = { 1.0, 1.0, 1.0 };
};

constexpr std::size_t MostMetrics = 2;

using MetricValues = std::array<double, MostMetrics>; // by metric

/// Sorts at most four boxes, the nearest last, faster than std::sort.
template <typename Waiting>
void SortByDistance(Waiting* first, Waiting* last)
{
  for (Waiting* next = first + 1; next < last; ++next)
  {
    const Waiting moved = *next;
    Waiting* place = next;
    for (; place > first && (place - 1)->SquaredDistance < moved.SquaredDistance; --place)
    {
      *place = *(place - 1);
    }
    *place = moved;
  }
}
}

#endif
