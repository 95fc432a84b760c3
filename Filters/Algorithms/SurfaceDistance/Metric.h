// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances in other units than those of the coordinates. A surface is given once, on its lattice, and is measured on
// the lattice and in the world: a linear map leads from one to the other, and searches in one structure serve both.

#ifndef SeismicHorizonsMetric_h
#define SeismicHorizonsMetric_h

#include "ClosestPoint.h"
#include "TriangleSurface.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
/// Maps differences of places to where distances are measured. Turning and mirroring leave distances as they are, so
/// that a triangular matrix stands for any map: x to (Plan(0, 0) x, 0), y to (Plan(0, 1), Plan(1, 1)) y, and z to
/// Vertical z.
class Metric
{
public:
  /// That of the coordinates.
  Metric() = default;

  /// `plan` maps x and y, `vertical` z; neither has to keep any direction, but none may vanish.
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

  /// The transposed map.
  Eigen::Vector3d Transposed(const Eigen::Vector3d& v) const
  {
    return { this->XtoX * v.x(), this->YtoX * v.x() + this->YtoY * v.y(), this->ZtoZ * v.z() };
  }

  /// The length of a difference is at least that of its coordinates times these.
  const Eigen::Array3d& Weights() const { return this->AxisWeights; }

  /// The square of an area in plan is so much of that of its image.
  double SquaredPlanShrinkage() const { return this->Shrinkage; }

  /// A difference in plan becomes at most so many times as long; the square.
  double SquaredPlanNorm() const { return this->XtoX * this->XtoX + this->YtoX * this->YtoX + this->YtoY * this->YtoY; }

  double Length(const Eigen::Vector3d& v) const { return (*this)(v).norm(); }

  double Area(const TriangleSurface& surface, const Corners& t) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return 0.5 * (*this)(surface.Point(t[1]) - a).cross((*this)(surface.Point(t[2]) - a)).norm();
  }

  /// The squared distance from a place to a triangle.
  double SquaredDistance(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    return SquaredDistanceToTriangle(
      (*this)(place - a), Eigen::Vector3d::Zero(), (*this)(surface.Point(t[1]) - a), (*this)(surface.Point(t[2]) - a));
  }

  /// The same to the box of a triangle at most: never farther away.
  double SquaredDistanceToBox(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d& a = surface.Point(t[0]);
    const Eigen::Vector3d& b = surface.Point(t[1]);
    const Eigen::Vector3d& c = surface.Point(t[2]);
    // Two coordinates at a time.
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
}

#endif
