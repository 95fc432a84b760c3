// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Principal axes and least squares of three unknowns. They are compiled once, as Eigen's solvers take seconds of the
// compiler in each file that uses them.

#ifndef SeismicHorizonsLeastSquares_h
#define SeismicHorizonsLeastSquares_h

#include <Eigen/Core>

namespace SeismicHorizons
{
/// Of a symmetric matrix, by ascending eigenvalue.
template <int Size>
struct PrincipalAxes
{
  Eigen::Matrix<double, Size, 1> Values;
  Eigen::Matrix<double, Size, Size> Axes; // columns, of length 1
};

PrincipalAxes<2> FindPrincipalAxes(const Eigen::Matrix2d& matrix);
PrincipalAxes<3> FindPrincipalAxes(const Eigen::Matrix3d& matrix);

struct LeastSquares
{
  Eigen::Vector3d Unknowns;
  Eigen::Index Rank = 0; // below 3 some of the unknowns are free, and 0
};

/// Each row has the factors of one equation.
LeastSquares SolveLeastSquares(const Eigen::MatrixX3d& rows, const Eigen::VectorXd& right);
}

#endif
