// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeFrame_h
#define SeismicHorizonsLatticeFrame_h

#include "LatticeHorizon.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"
#include "VerticalSampling.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace SeismicHorizons
{
/// Row-major affine map from (i, j, k) to world coordinates, as in the field data array LatticeToWorld.
using LatticeMatrix = std::array<double, 16>;

enum class VerticalDirection
{
  Down = -1, ///< Time and depth increase downwards.
  Up = 1
};

struct LatticeFrame
{
  SurveyLattice Lattice;
  VerticalSampling Sampling; // Samples real z; Direction gives the sign of world z.
  VerticalDirection Direction = VerticalDirection::Down;
  bool UseRealZ = true; // False places points at their vertical index.
  SurveyDescription Survey;
  std::optional<double> LatticeDeviation; // Largest distance of picks or traces from their columns, in columns.

  double Elevation(double k) const
  {
    const int sign = static_cast<int>(this->Direction);
    return sign * this->Sampling.Step * k + sign * this->Sampling.First;
  }

  double Elevation(const LatticeHorizon& horizon, std::size_t point) const
  {
    return this->UseRealZ ? static_cast<int>(this->Direction) * horizon.RealZ[point]
                          : this->Elevation(horizon.K[point]);
  }

  LatticeMatrix ToWorld() const;

  /// Throws InputError, with the names of properties, for invalid numbers, parallel steps and a vertical step of 0.
  void Check() const;
};

/// The lattice must be able to hold `toWorld`.
LatticeFrame MakeLatticeFrame(
  const std::array<int, 3>& size, const Eigen::Matrix4d& toWorld, VerticalDirection direction);

std::string ToText(const Eigen::VectorXd& vector);
}

#endif
