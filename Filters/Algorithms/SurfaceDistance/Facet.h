// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle that many places are above or below, one after the other.

#ifndef SeismicHorizonsFacet_h
#define SeismicHorizonsFacet_h

#include "Metric.h"
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
    this->Origin = surface.Point(t[0]);
    this->IsAlone = isAlone;
    this->Slack = slack;
    this->Heights = { surface.Point(t[0]).z(), surface.Point(t[1]).z(), surface.Point(t[2]).z() };
    const Eigen::Vector3d sides[3] = { surface.Point(t[1]) - surface.Point(t[0]),
      surface.Point(t[2]) - surface.Point(t[1]), surface.Point(t[0]) - surface.Point(t[2]) };
    this->Second = sides[0].head<2>();
    for (std::size_t side = 0; side < 3; ++side)
    {
      this->Along[side] = sides[side].head<2>();
    }
    if (Cross(this->Along[0], this->Along[1]) < 0.0)
    {
      for (Eigen::Vector2d& along : this->Along)
      {
        along = -along;
      }
    }
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
    const Eigen::Vector2d toFirst = (place - this->Origin).head<2>();
    const Eigen::Vector2d toSecond = toFirst - this->Second;
    this->Areas[0] = Cross(this->Along[0], toFirst);
    this->Areas[1] = Cross(this->Along[1], toSecond);
    this->Areas[2] = Cross(this->Along[2], toFirst);
    return this->Number >= 0 && std::min({ this->Areas[0], this->Areas[1], this->Areas[2] }) >= 0.0;
  }

  /// Of a place that it contains: whether the nearest place of the surface is known to be on this triangle's face, as
  /// the ball around the place that touches its plane is well within the triangle in plan; with the squared distance.
  bool IsNearest(std::size_t metric, const Eigen::Vector3d& place, double& squared) const
  {
    const Plane& plane = this->Planes[metric];
    const double height = plane.Normal.dot(place - this->Origin);
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
    return (this->Areas[1] * this->Heights[0] + this->Areas[2] * this->Heights[1] + this->Areas[0] * this->Heights[2]) /
      (this->Areas[0] + this->Areas[1] + this->Areas[2]);
  }

  /// Of a place that it contains: whether no other triangle is within that distance of the place in plan.
  bool IsOnlyOne(double distance) const
  {
    const double squared = (distance + this->Slack) * (distance + this->Slack);
    return this->IsAlone && this->Areas[0] * this->Areas[0] > squared * this->Along[0].squaredNorm() &&
      this->Areas[1] * this->Areas[1] > squared * this->Along[1].squaredNorm() &&
      this->Areas[2] * this->Areas[2] > squared * this->Along[2].squaredNorm();
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

  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

  static void SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane)
  {
    const Eigen::Vector3d mapped[3] = { metric(sides[0]), metric(sides[1]), metric(sides[2]) };
    const Eigen::Vector3d normal = mapped[0].cross(mapped[1]);
    const double square = normal.squaredNorm();
    const double longest = std::max({ mapped[0].squaredNorm(), mapped[1].squaredNorm(), mapped[2].squaredNorm() });
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
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero();
  std::array<double, 3> Heights = {}; // of the corners
  Eigen::Vector2d Second = Eigen::Vector2d::Zero(); // the second corner, from the first one
  std::array<Eigen::Vector2d, 3> Along = { Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero() };
  std::array<double, 3> Areas = {};
  std::array<Plane, MostMetrics> Planes;
};
}

#endif
