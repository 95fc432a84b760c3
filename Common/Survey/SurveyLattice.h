// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyLattice_h
#define SeismicHorizonsSurveyLattice_h

#include <Eigen/Core>

#include <array>
#include <optional>

namespace SeismicHorizons
{
/// Crosslines are along i, inlines along j.
struct LineNumbering
{
  double FirstCrossline = 0.0; // At i = 0.
  double CrosslineStep = 1.0; // Per column along i; not 0.
  double FirstInline = 0.0;
  double InlineStep = 1.0;
};

struct SurveyLattice
{
  std::array<int, 2> Columns = { 1, 1 }; // Along i and j.
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero(); // Position of column (0, 0).
  Eigen::Vector2d ColumnStep = Eigen::Vector2d::UnitX(); // World units to the next column along i.
  Eigen::Vector2d RowStep = Eigen::Vector2d::UnitY(); // World units to the next column along j.
  std::optional<LineNumbering> Lines;

  Eigen::Matrix2d Steps() const { return (Eigen::Matrix2d() << this->ColumnStep, this->RowStep).finished(); }
};
}

#endif
