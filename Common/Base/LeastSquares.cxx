// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LeastSquares.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PrincipalAxes<2> FindPrincipalAxes(const Eigen::Matrix2d& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(matrix);
  return { solver.eigenvalues(), solver.eigenvectors() };
}

//----------------------------------------------------------------------------------------------------------------------
PrincipalAxes<3> FindPrincipalAxes(const Eigen::Matrix3d& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  return { solver.eigenvalues(), solver.eigenvectors() };
}

//----------------------------------------------------------------------------------------------------------------------
LeastSquares SolveLeastSquares(const Eigen::MatrixX3d& rows, const Eigen::VectorXd& right)
{
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> solver(rows);
  return { solver.solve(right), solver.rank() };
}
}
