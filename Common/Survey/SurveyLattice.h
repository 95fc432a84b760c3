// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyLattice_h
#define SeismicHorizonsSurveyLattice_h

#include <Eigen/Core>

#include <array>
#include <optional>

namespace SeismicHorizons
{
/// The inlines and crosslines of a survey: crosslines count along i, and inlines along j.
struct LineNumbering
{
  double FirstCrossline = 0.0; // of i = 0
  double CrosslineStep = 1.0; // from a column to the next along i; not 0
  double FirstInline = 0.0; // of j = 0
  double InlineStep = 1.0;
};

/// The columns of a survey seen from above, in world units.
struct SurveyLattice
{
  std::array<int, 2> Columns = { 1, 1 }; // along i and j
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero(); // the place of column (0, 0)
  Eigen::Vector2d ColumnStep = Eigen::Vector2d::UnitX(); // from a column to the next one along i
  Eigen::Vector2d RowStep = Eigen::Vector2d::UnitY(); // the same along j
  std::optional<LineNumbering> Lines; // where they are known

  /// The two steps as columns.
  Eigen::Matrix2d Steps() const { return (Eigen::Matrix2d() << this->ColumnStep, this->RowStep).finished(); }
};
}

#endif
