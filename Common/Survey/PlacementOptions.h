// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlacementOptions_h
#define SeismicHorizonsPlacementOptions_h

#include "DuplicatePolicy.h"
#include "LatticeFrame.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace SeismicHorizons
{
enum class LatticeSource
{
  Picks, ///< Uses line numbers, places, or both.
  CornerPoints, ///< Uses three points with line numbers and places.
  OriginAndSteps
};

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
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero(); // Position of the first crossline and inline.
  Eigen::Vector2d ColumnStep = Eigen::Vector2d::UnitX(); // to the next column along i
  Eigen::Vector2d RowStep = Eigen::Vector2d::UnitY();
  std::optional<LineNumbering> Lines; // Of the lattice with OriginAndSteps, else found from the picks.
  double Tolerance = 0.1; // Largest distance of picks from their columns, in columns; above 0, below 0.5.
  // Drops up to a tenth of the picks, off the lattice or far from the rest; otherwise they are an error.
  bool LeaveOutStrays = false;
  DuplicatePolicy Policy = DuplicatePolicy::StrongestAmplitude;
  VerticalDirection Direction = VerticalDirection::Down; // Defines the topmost pick.
};

/// Throws InputError with the names of properties.
void CheckPlacement(const PlacementOptions& options);
}

#endif
