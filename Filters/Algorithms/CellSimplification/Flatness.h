// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deviation of points from a plane by principal component analysis (thesis 4.3.2.4.1, eq. 4.4 and 4.5), also known as
// surface variation (Pauly, Gross, Kobbelt 2002).

#ifndef SeismicHorizonsFlatness_h
#define SeismicHorizonsFlatness_h

#include "Common/Horizon/Types.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
class Covariance
{
public:
  /// `origin` should be one of the points, since sums relative to it lose little to rounding.
  explicit Covariance(const SpacePoint& origin)
    : Origin(origin)
  {
  }

  void Add(const SpacePoint& place, double weight)
  {
    const double x = place.X - this->Origin.X;
    const double y = place.Y - this->Origin.Y;
    const double z = place.Z - this->Origin.Z;
    this->Weight += weight;
    this->X += weight * x;
    this->Y += weight * y;
    this->Z += weight * z;
    this->XX += weight * x * x;
    this->XY += weight * x * y;
    this->XZ += weight * x * z;
    this->YY += weight * y * y;
    this->YZ += weight * y * z;
    this->ZZ += weight * z * z;
  }

  Eigen::Matrix3d Matrix() const
  {
    const Eigen::Vector3d mean = Eigen::Vector3d(this->X, this->Y, this->Z) / this->Weight;
    Eigen::Matrix3d products;
    products << this->XX, this->XY, this->XZ, this->XY, this->YY, this->YZ, this->XZ, this->YZ, this->ZZ;
    return products / this->Weight - mean * mean.transpose();
  }

private:
  SpacePoint Origin;
  double Weight = 0.0;
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
  double XX = 0.0;
  double XY = 0.0;
  double XZ = 0.0;
  double YY = 0.0;
  double YZ = 0.0;
  double ZZ = 0.0;
};

/// Returns the least eigenvalue divided by the sum of all three (eq. 4.5): 0 for a plane, at most 1/3.
inline double LeastEigenvalueFraction(const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver, double sum)
{
  return sum > 0.0 ? std::max(0.0, solver.eigenvalues()[0] / sum) : 0.0; // Rounding can make the quotient negative.
}

inline double Flatness(const Eigen::Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return LeastEigenvalueFraction(solver, covariance.trace());
}

/// The closed formula is several times faster. Its error is below 1e-6, and about 1e-8 (the root of rounding) if two
/// eigenvalues are nearly equal.
inline double QuickFlatness(const Eigen::Matrix3d& covariance)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return LeastEigenvalueFraction(solver, covariance.trace());
}

/// Tests Flatness(covariance) <= threshold with tolerance for rounding, so that a plane is flat for a threshold of 0.
inline bool IsFlatWithin(const Eigen::Matrix3d& covariance, double threshold)
{
  // Rounding of the sums and of the iterative solver is about 1e-15 of the sum of eigenvalues.
  constexpr double rounding = 1e-12;
  constexpr double roundingOfClosedFormula = 1e-6;
  if (threshold >= 1.0 / 3.0)
  {
    return true;
  }
  const double quick = QuickFlatness(covariance);
  if (std::abs(quick - threshold) > roundingOfClosedFormula)
  {
    return quick < threshold;
  }
  return Flatness(covariance) <= threshold + rounding;
}
}

#endif
