// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeFrame_h
#define SeismicHorizonsLatticeFrame_h

#include "Common/LatticeHorizon.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"
#include "VerticalSampling.h"

#include <array>
#include <cstddef>
#include <optional>
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

/// Where the horizons of a lattice lie in the world, and in which units.
struct LatticeFrame
{
  SurveyLattice Lattice;
  VerticalSampling Sampling; // of real z, whose sign in the world is that of the direction
  VerticalDirection Direction = VerticalDirection::Down;
  bool UseRealZ = true; // points are at their real z; else where their vertical index is
  SurveyDescription Survey;
  std::optional<double> LatticeDeviation; // of picks or traces from their columns, at most, in columns

  /// World z of a vertical index.
  double Elevation(double k) const
  {
    const int sign = static_cast<int>(this->Direction);
    return sign * this->Sampling.Step * k + sign * this->Sampling.First;
  }

  /// World z of a point.
  double Elevation(const LatticeHorizon& horizon, std::size_t point) const
  {
    return this->UseRealZ ? static_cast<int>(this->Direction) * horizon.RealZ[point]
                          : this->Elevation(horizon.K[point]);
  }

  LatticeMatrix ToWorld() const;

  /// Throws InputError on numbers that are not finite, on column and row steps that are parallel, and on a vertical
  /// step of 0. The message has the names of the properties.
  void Check() const;
};

/// The frame of a lattice by its size along i, j and k, and by its map to the world, which is one that Lattice takes.
LatticeFrame MakeLatticeFrame(
  const std::array<int, 3>& size, const Eigen::Matrix4d& toWorld, VerticalDirection direction);

/// A vector as messages show it: "(1.5, 2)".
std::string ToText(const Eigen::VectorXd& vector);
}

#endif
