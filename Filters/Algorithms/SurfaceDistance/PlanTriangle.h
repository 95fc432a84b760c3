// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//

#ifndef SeismicHorizonsPlanTriangle_h
#define SeismicHorizonsPlanTriangle_h

#include "TriangleSurface.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace SeismicHorizons
{
/// Corners may be in either order.
struct PlanTriangle
{
  std::array<Eigen::Vector2d, 3> Corner;

  explicit PlanTriangle(const std::array<Eigen::Vector3d, 3>& corners)
    : Corner{ corners[0].head<2>(), corners[1].head<2>(), corners[2].head<2>() }
  {
  }

  PlanTriangle(const TriangleSurface& surface, const Corners& t)
    : Corner{ surface.Point(t[0]).head<2>(), surface.Point(t[1]).head<2>(), surface.Point(t[2]).head<2>() }
  {
  }

  /// Returns twice the area, positive if the place is left of the edge.
  double DoubledArea(std::size_t side, const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d along = this->Corner[(side + 1) % 3] - this->Corner[side];
    const Eigen::Vector2d to = place - this->Corner[side];
    return along.x() * to.y() - along.y() * to.x();
  }
  /// Positive for counter-clockwise corners.
  double DoubledArea() const { return this->DoubledArea(0, this->Corner[2]); }

  double SquaredLongest() const
  {
    return std::max({ (this->Corner[1] - this->Corner[0]).squaredNorm(),
      (this->Corner[2] - this->Corner[1]).squaredNorm(), (this->Corner[0] - this->Corner[2]).squaredNorm() });
  }

  double Low(int axis) const
  {
    return std::min({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }
  double High(int axis) const
  {
    return std::max({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }

  bool MayReach(const Eigen::Vector3d& place, double tolerance) const
  {
    const auto low = this->Corner[0].array().min(this->Corner[1].array()).min(this->Corner[2].array());
    const auto high = this->Corner[0].array().max(this->Corner[1].array()).max(this->Corner[2].array());
    const auto plan = place.head<2>().array();
    return (low - plan).max(plan - high).maxCoeff() <= tolerance;
  }
};

/// Edges count as beyond up to rounding.
inline bool IsBeyondSide(const PlanTriangle& triangle, double doubledArea, const PlanTriangle& other)
{
  const double turn = doubledArea < 0.0 ? -1.0 : 1.0;
  const double rounding = 1e-12 * std::abs(doubledArea);
  for (std::size_t side = 0; side < 3; ++side)
  {
    if (turn * triangle.DoubledArea(side, other.Corner[0]) <= rounding &&
      turn * triangle.DoubledArea(side, other.Corner[1]) <= rounding &&
      turn * triangle.DoubledArea(side, other.Corner[2]) <= rounding)
    {
      return true;
    }
  }
  return false;
}

/// Ignores overlaps by rounding. One of two disjoint convex shapes is beyond an edge of the other. Without area, boxes
/// decide.
inline bool Overlap(const PlanTriangle& a, const PlanTriangle& b)
{
  if (a.High(0) < b.Low(0) || b.High(0) < a.Low(0) || a.High(1) < b.Low(1) || b.High(1) < a.Low(1))
  {
    return false;
  }
  const double areaOfA = a.DoubledArea();
  const double areaOfB = b.DoubledArea();
  return areaOfA == 0.0 || areaOfB == 0.0 || (!IsBeyondSide(a, areaOfA, b) && !IsBeyondSide(b, areaOfB, a));
}

/// Returns the range of x between two values of y.
inline std::array<double, 2> SpanWithin(const PlanTriangle& triangle, double low, double high)
{
  std::array<double, 2> span = { triangle.High(0), triangle.Low(0) };
  const auto add = [&span](double x) { span = { std::min(span[0], x), std::max(span[1], x) }; };
  for (std::size_t side = 0; side < 3; ++side)
  {
    const Eigen::Vector2d& from = triangle.Corner[side];
    const Eigen::Vector2d& to = triangle.Corner[(side + 1) % 3];
    if (from.y() >= low && from.y() <= high)
    {
      add(from.x());
    }
    for (const double y : { low, high })
    {
      if ((from.y() < y) != (to.y() < y))
      {
        add(from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
      }
    }
  }
  return span;
}
}

#endif
