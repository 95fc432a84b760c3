// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a lattice lies in the world, as users of readers give it.

#ifndef SeismicHorizonsLatticePlacement_h
#define SeismicHorizonsLatticePlacement_h

#include <Eigen/Core>

#include <array>
#include <string>

namespace SeismicHorizons
{
/// The affine map from (i, j, k) to world coordinates, row by row, as in the field data array LatticeToWorld.
using LatticeMatrix = std::array<double, 16>;

/// Which way vertical indices count. The values are the sign of their z.
enum class VerticalDirection
{
  Down = -1, ///< as time and depth do
  Up = 1
};

/// All lengths are in world units.
struct LatticePlacement
{
  Eigen::Vector3d Origin = Eigen::Vector3d::Zero(); // the centre of cell (0, 0, 0)
  Eigen::Vector2d ColumnStep = Eigen::Vector2d::UnitX(); // in x and y, from a cell to the next one along i
  Eigen::Vector2d RowStep = Eigen::Vector2d::UnitY(); // the same along j
  double VerticalStep = 1.0; // from a vertical index to the next one, in their direction
  VerticalDirection Direction = VerticalDirection::Down;

  /// Throws InputError on numbers that are not finite, on column and row steps that are parallel, and on a vertical
  /// step of 0. The message has the names of the members.
  void Check() const;

  LatticeMatrix ToWorld() const;
};

/// A vector as messages show it: "(1.5, 2)".
std::string ToText(const Eigen::VectorXd& vector);
}

#endif
