// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An edge of a simplified loop, for asking how far the points are from it that it spans.

#ifndef SeismicHorizonsSpanningEdge_h
#define SeismicHorizonsSpanningEdge_h

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
/// Distances of a place from an edge seen from above, and in height where it is nearest so.
struct MapDistances
{
  double InPlan;
  double InHeight;
};

class SpanningEdge
{
public:
  SpanningEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    : From(from)
    , Along(to - from)
  {
  }

  double InSpace(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d way = place - this->From;
    return (way - NearestPart(this->Along, way) * this->Along).norm();
  }

  MapDistances OnMap(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d way = place - this->From;
    const Eigen::Vector3d off = way - NearestPart<Eigen::Vector2d>(this->Along.head<2>(), way.head<2>()) * this->Along;
    return { this->IsOnMap(way) ? 0.0 : off.head<2>().norm(), std::abs(off.z()) };
  }

private:
  /// Where on the segment from the origin to `along` the place nearest to `way` is: 0 at the origin, 1 at its other
  /// end.
  template <typename Vector>
  static double NearestPart(const Vector& along, const Vector& way)
  {
    const double length = along.squaredNorm();
    return length > 0.0 ? std::min(1.0, std::max(0.0, along.dot(way) / length)) : 0.0;
  }

  /// Whether the end of a way from our first end is on us, seen from above. Boundary points stand on whole columns, so
  /// that products are exact, and nothing is lost to rounding on a straight run.
  bool IsOnMap(const Eigen::Vector3d& way) const
  {
    const double part = this->Along.head<2>().dot(way.head<2>());
    return this->Along.x() * way.y() == this->Along.y() * way.x() && part >= 0.0 &&
      part <= this->Along.head<2>().squaredNorm();
  }

  Eigen::Vector3d From;
  Eigen::Vector3d Along;
};
}

#endif
