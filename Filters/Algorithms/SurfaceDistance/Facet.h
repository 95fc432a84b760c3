// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle that many places are above or below, one after the other.

#ifndef SeismicHorizonsFacet_h
#define SeismicHorizonsFacet_h

#include "Metric.h"
#include "TriangleHeight.h"
#include "TriangleSurface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Lattice and world.
constexpr std::size_t MostMetrics = 2;

class Facet
{
  // Squares of sums: (a + b)^2 is at most LittleMore a^2 + MuchMore b^2.
  static constexpr double LittleMore = 1.01;
  static constexpr double MuchMore = 101.0;

  // Of needles, squares: the width over the length, and what rounding does at their ends, over the length.
  static constexpr double LeastWidth = 1e-12;
  static constexpr double RoundingAtEnds = 1e-17;

public:
  /// No triangle.
  Facet() = default;

  /// `isAlone` tells that no other triangle overlaps it in plan, but for a strip along its sides that is narrower than
  /// `slack`.
  void Set(
    const TriangleSurface& surface, std::int32_t number, bool isAlone, double slack, const std::vector<Metric>& metrics)
  {
    const Corners& t = surface.Triangles[std::size_t(number)];
    this->Number = number;
    this->IsAlone = isAlone;
    this->Slack = slack;
    this->Corner = { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) };
    // The sides across from each corner.
    const Eigen::Vector3d sides[3] = { this->Corner[2] - this->Corner[1], this->Corner[0] - this->Corner[2],
      this->Corner[1] - this->Corner[0] };
    this->Turn = sides[0].x() * sides[1].y() - sides[0].y() * sides[1].x() < 0.0 ? -1.0 : 1.0;
    for (std::size_t n = 0; n < metrics.size(); ++n)
    {
      this->Planes[n].SquaredSlack = MuchMore * slack * slack * metrics[n].SquaredPlanNorm();
      SetPlane(metrics[n], sides, this->Planes[n]);
      this->Planes[n].IsSure = this->Planes[n].IsSure && isAlone;
    }
  }

  std::int32_t GetNumber() const { return this->Number; }

  /// Takes a place: twice the areas of the sides with it, positive inside.
  bool Contains(const Eigen::Vector3d& place)
  {
    const std::array<double, 3> areas = DoubledAreas(place, this->Corner[0], this->Corner[1], this->Corner[2]);
    this->Areas = { this->Turn * areas[0], this->Turn * areas[1], this->Turn * areas[2] };
    return this->Number >= 0 && this->Areas[0] >= 0.0 && this->Areas[1] >= 0.0 && this->Areas[2] >= 0.0;
  }

  /// Of a place that it contains: whether the nearest place of the surface is known to be on this triangle's face, as
  /// the ball around the place that touches its plane is well within the triangle in plan; with the squared distance.
  bool IsNearest(std::size_t metric, const Eigen::Vector3d& place, double& squared) const
  {
    const Plane& plane = this->Planes[metric];
    const double height = plane.Normal.dot(place - this->Corner[0]);
    squared = height * height / plane.SquaredNormal;
    const double grown = (LittleMore * squared + plane.SquaredSlack) * plane.Shrinkage;
    return this->Areas[0] * this->Areas[0] >= grown * plane.SquaredSides[0] &&
      this->Areas[1] * this->Areas[1] >= grown * plane.SquaredSides[1] &&
      this->Areas[2] * this->Areas[2] >= grown * plane.SquaredSides[2] && plane.IsSure;
  }

  /// Whether that squared distance has as many digits as that of SquaredDistanceToTriangle; not so for a needle.
  bool IsWide(std::size_t metric) const { return this->Planes[metric].IsWide; }

  /// Of a place that it contains: the z of the triangle there.
  double Height() const
  {
    return (this->Areas[0] * this->Corner[0].z() + this->Areas[1] * this->Corner[1].z() +
             this->Areas[2] * this->Corner[2].z()) /
      (this->Areas[0] + this->Areas[1] + this->Areas[2]);
  }

  /// Of a place that it contains: whether no other triangle is within that distance of the place in plan.
  bool IsOnlyOne(double distance) const
  {
    const double squared = (distance + this->Slack) * (distance + this->Slack);
    const auto isFar = [&](std::size_t n)
    {
      const auto side = (this->Corner[(n + 1) % 3] - this->Corner[(n + 2) % 3]).head<2>();
      return this->Areas[n] * this->Areas[n] > squared * side.squaredNorm();
    };
    return this->IsAlone && isFar(0) && isFar(1) && isFar(2);
  }

private:
  struct Plane
  {
    Eigen::Vector3d Normal = Eigen::Vector3d::Zero(); // times the difference of places: the distance, times its length
    double SquaredNormal = 1.0; // the square of that length
    std::array<double, 3> SquaredSides = {}; // in plan
    double Shrinkage = 1.0; // times the square of an area in plan: that of the coordinates
    double SquaredSlack = 0.0; // MuchMore times as large
    bool IsSure = false;
    bool IsWide = false;
  };

  static void SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane)
  {
    const Eigen::Vector3d mapped[3] = { metric(sides[0]), metric(sides[1]), metric(sides[2]) };
    const Eigen::Vector3d normal = mapped[0].cross(mapped[1]);
    const double square = normal.squaredNorm();
    const double longest =
      std::max(std::max(mapped[0].squaredNorm(), mapped[1].squaredNorm()), mapped[2].squaredNorm());
    plane.Normal = metric.Transposed(normal);
    plane.SquaredNormal = square;
    plane.Shrinkage = metric.SquaredPlanShrinkage();
    for (std::size_t side = 0; side < 3; ++side)
    {
      plane.SquaredSides[side] = mapped[side].head<2>().squaredNorm();
    }
    plane.IsWide = square > SquaredWidthOfNeedle * longest * longest;
    // The plane of a needle is wrong at its ends by rounding times its length over its width, and the length. That has
    // to be less than the slack.
    plane.IsSure =
      plane.IsWide || (square > LeastWidth * longest * longest && RoundingAtEnds * longest <= plane.SquaredSlack);
  }

  std::int32_t Number = -1;
  bool IsAlone = false;
  double Slack = 0.0;
  std::array<Eigen::Vector3d, 3> Corner = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() };
  double Turn = 1.0; // -1 where corners go to the right
  std::array<double, 3> Areas = {}; // of the sides across from each corner with the last place
  std::array<Plane, MostMetrics> Planes;
};
}

#endif
