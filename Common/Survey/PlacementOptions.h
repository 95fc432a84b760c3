// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlacementOptions_h
#define SeismicHorizonsPlacementOptions_h

#include "Common/DuplicatePolicy.h"
#include "LatticeFrame.h"

#include <Eigen/Core>

#include <array>

namespace SeismicHorizons
{
/// Where the lattice of picks comes from.
enum class LatticeSource
{
  Picks, ///< from their line numbers and places, from their places alone, or, without places, from line numbers alone
  CornerPoints, ///< from three points whose line numbers and places the user gives
  OriginAndSteps ///< from what the user gives
};

/// A column whose line numbers and place are known.
struct CornerPoint
{
  double Inline = 0.0;
  double Crossline = 0.0;
  double X = 0.0;
  double Y = 0.0;
};

struct PlacementOptions
{
  LatticeSource Source = LatticeSource::Picks;
  std::array<CornerPoint, 3> Corners;
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero(); // the place of the column of the first crossline and inline
  Eigen::Vector2d ColumnStep = Eigen::Vector2d::UnitX(); // along i to the next column
  Eigen::Vector2d RowStep = Eigen::Vector2d::UnitY();
  double Tolerance = 0.1; // how far picks may be off their columns, in columns; above 0, below 0.5
  bool LeaveOutStrays = false; // picks off the lattice or far from all others, up to a tenth; else these are an error
  DuplicatePolicy Policy = DuplicatePolicy::StrongestAmplitude;
  VerticalDirection Direction = VerticalDirection::Down; // where z grows to: says what is topmost
};

/// Throws InputError, with the names of the properties, on options that cannot be: numbers that are not finite, a
/// tolerance out of its range, and, where they are used, steps that are parallel.
void CheckPlacement(const PlacementOptions& options);
}

#endif
