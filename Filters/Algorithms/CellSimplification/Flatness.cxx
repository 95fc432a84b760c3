// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Flatness.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// The sums and the iterative solver are rounded to some 1e-15 of the sum of the eigenvalues; this is well above.
constexpr double Rounding = 1e-12;
// Where two eigenvalues are nearly equal, the closed formula can be wrong by the root of that, some 1e-8.
constexpr double RoundingOfClosedFormula = 1e-6;

/// The least eigenvalue as a part of their sum. Rounding can make it negative.
double LeastPart(const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>& solver, double sum)
{
  return sum > 0.0 ? std::max(0.0, solver.eigenvalues()[0] / sum) : 0.0;
}
}

//----------------------------------------------------------------------------------------------------------------------
double Flatness(const Eigen::Matrix3d& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return LeastPart(solver, covariance.trace());
}

//----------------------------------------------------------------------------------------------------------------------
double QuickFlatness(const Eigen::Matrix3d& covariance)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return LeastPart(solver, covariance.trace());
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFlatWithin(const Eigen::Matrix3d& covariance, double threshold)
{
  if (threshold >= 1.0 / 3.0)
  {
    return true;
  }
  const double quick = QuickFlatness(covariance);
  if (std::abs(quick - threshold) > RoundingOfClosedFormula)
  {
    return quick < threshold;
  }
  // Only near the threshold the iterative solver has to decide.
  return Flatness(covariance) <= threshold + Rounding;
}
}
