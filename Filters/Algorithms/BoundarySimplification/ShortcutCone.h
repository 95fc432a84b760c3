// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where an edge from a point can go that passes others within a tolerance: a wedge of directions on the map (Imai and
// Iri 1988; Chan and Chin 1996), and a range of slopes.
//
//              .  |  .
//            _____o_____      An edge passes o within the tolerance when its direction lies between the tangents of
//           .    /|\    .     the circle around o. Its place nearest to o is then at most as far from the start as o
//           .   / | \   .     is, and nearer by the tolerance at most; so much is known of the slope.
//              . \|/
//                 x

#ifndef SeismicHorizonsShortcutCone_h
#define SeismicHorizonsShortcutCone_h

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace SeismicHorizons
{
/// What no edge within the tolerances is outside of; one that is inside need not be within them.
class ShortcutCone
{
public:
  ShortcutCone(double outlineTolerance, double heightTolerance)
    : Radius(outlineTolerance + PlanSlack)
    , HeightTolerance(heightTolerance)
  {
  }

  /// Whether no edge of any length is left.
  bool IsEmpty() const { return this->HasNoDirection || this->LeastSlope > this->GreatestSlope; }

  /// Whether an edge can lead to the end of a way from the start; leaves only edges that pass it within the tolerances.
  bool Pass(const Eigen::Vector3d& way)
  {
    const double length = way.head<2>().norm();
    const double slack = HeightSlack * std::abs(way.z());
    const bool hasDirection = this->IsWhole || IsBetween(this->Right, this->Left, way.head<2>());
    const bool hasSlope =
      way.z() + slack >= this->LeastSlope * length && way.z() - slack <= this->GreatestSlope * length;
    if (length > this->Radius)
    {
      this->NarrowDirections(way.head<2>(), std::sqrt(length * length - this->Radius * this->Radius));
    }
    const double nearest = std::max(0.0, length - this->Radius);
    const double tolerance = this->HeightTolerance + slack;
    this->LeastSlope = std::max(this->LeastSlope, -GreatestOf(tolerance - way.z(), nearest, length));
    this->GreatestSlope = std::min(this->GreatestSlope, GreatestOf(tolerance + way.z(), nearest, length));
    return hasDirection && hasSlope;
  }

private:
  // Far more than rounding can be, for coordinates below 2^29, and far too little to matter. The second is a part of
  // the height.
  static constexpr double PlanSlack = 1e-6;
  static constexpr double HeightSlack = 1e-9;

  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

  /// Whether a direction is between two others, of which the second is less than half a turn to the left of the first.
  static bool IsBetween(const Eigen::Vector2d& right, const Eigen::Vector2d& left, const Eigen::Vector2d& direction)
  {
    return Cross(right, direction) >= 0.0 && Cross(direction, left) >= 0.0;
  }

  /// The greatest slope that is at most `height` up at some distance from `nearest` to `farthest`.
  static double GreatestOf(double height, double nearest, double farthest)
  {
    const double distance = height >= 0.0 ? nearest : farthest;
    return distance > 0.0 ? height / distance : std::copysign(std::numeric_limits<double>::infinity(), height);
  }

  void NarrowDirections(const Eigen::Vector2d& way, double tangent)
  {
    const Eigen::Vector2d aside = this->Radius * Eigen::Vector2d(-way.y(), way.x());
    const Eigen::Vector2d right = tangent * way - aside;
    const Eigen::Vector2d left = tangent * way + aside;
    const double rightToRight = Cross(this->Right, right);
    const double rightToLeft = Cross(this->Right, left);
    const double leftToRight = Cross(right, this->Left);
    const double leftToLeft = Cross(left, this->Left);
    const bool hasRight = this->IsWhole || (rightToRight >= 0.0 && leftToRight >= 0.0);
    const bool hasLeft = this->IsWhole || (rightToLeft >= 0.0 && leftToLeft >= 0.0);
    const bool keepsRight = rightToRight <= 0.0 && rightToLeft >= 0.0;
    const bool keepsLeft = leftToRight >= 0.0 && leftToLeft <= 0.0;
    this->HasNoDirection = !(hasRight || keepsRight) || !(hasLeft || keepsLeft);
    this->Right = hasRight ? right : this->Right;
    this->Left = hasLeft ? left : this->Left;
    this->IsWhole = false;
  }

  double Radius;
  double HeightTolerance;
  bool IsWhole = true;
  bool HasNoDirection = false;
  Eigen::Vector2d Right{ 0.0, 0.0 };
  Eigen::Vector2d Left{ 0.0, 0.0 };
  double LeastSlope = -std::numeric_limits<double>::infinity();
  double GreatestSlope = std::numeric_limits<double>::infinity();
};
}

#endif
