// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Flatness.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace SeismicHorizons
{
namespace
{
// What the sums and the iterative solver lose, with room to spare.
constexpr double Rounding = 1e-12;
// The closed formula can be wrong by the root of the machine precision where two eigenvalues are nearly equal.
constexpr double RoundingOfClosedFormula = 1e-6;

double Part(const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver, double sum)
{
  return solver.eigenvalues()[0] / sum;
}
}

//----------------------------------------------------------------------------------------------------------------------
double Flatness(const Eigen::Matrix3d& covariance)
{
  const double sum = covariance.trace();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return sum > 0.0 ? std::max(0.0, Part(solver, sum)) : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFlatWithin(const Eigen::Matrix3d& covariance, double threshold)
{
  const double sum = covariance.trace();
  if (threshold >= 1.0 / 3.0 || !(sum > 0.0))
  {
    return true;
  }
  // The closed formula is several times faster; only near the threshold it takes the iterative solver to decide.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  const double quick = Part(solver, sum);
  if (std::abs(quick - threshold) > RoundingOfClosedFormula)
  {
    return quick < threshold;
  }
  return Flatness(covariance) <= threshold + Rounding;
}
}
