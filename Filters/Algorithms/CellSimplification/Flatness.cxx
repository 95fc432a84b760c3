// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Flatness.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace SeismicHorizons
{
namespace
{
// The sums and the iterative solver are rounded to some 1e-15 of the sum of the eigenvalues; this is well above.
constexpr double Rounding = 1e-12;
// Where two eigenvalues are nearly equal, the closed formula can be wrong by the root of that, some 1e-8.
constexpr double RoundingOfClosedFormula = 1e-6;

/// The least eigenvalue as a part of their sum.
double LeastPart(const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver, double sum)
{
  return solver.eigenvalues()[0] / sum;
}
}

//----------------------------------------------------------------------------------------------------------------------
double Flatness(const Eigen::Matrix3d& covariance)
{
  const double sum = covariance.trace();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return sum > 0.0 ? std::max(0.0, LeastPart(solver, sum)) : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFlatWithin(const Eigen::Matrix3d& covariance, double threshold)
{
  const double sum = covariance.trace();
  if (threshold >= 1.0 / 3.0 || !(sum > 0.0))
  {
    return true;
  }
  // The closed formula is several times faster. Only near the threshold the iterative solver has to decide.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  const double quick = LeastPart(solver, sum);
  if (std::abs(quick - threshold) > RoundingOfClosedFormula)
  {
    return quick < threshold;
  }
  return Flatness(covariance) <= threshold + Rounding;
}
}
