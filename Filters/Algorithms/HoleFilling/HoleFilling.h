// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fills holes of a horizon before it has an outline.
//
// A hole is a group of empty columns, connected by edges, that a patch encloses. Each is filled independently, from
// known columns around it:
//  - Plate: a thin plate over the hole and a ring of known columns, which minimizes u_xx^2 + 2 u_xy^2 + u_yy^2 near the
//    heights of the ring (Briggs 1974, who interpolates them), so that the noise of single columns does not become the
//    slope of the surface. A membrane adds the residual at the ring, so that the rim has no step.
//  - Membrane: each new column is the mean of its four neighbours (Laplace's equation).
//
// Cuts divide a hole into sections; no stencil and no link crosses them. Memory is about 600 bytes per column of the
// largest hole, whatever its bounding box, the index, and up to 20 MB per thread.

#ifndef SeismicHorizonsHoleFilling_h
#define SeismicHorizonsHoleFilling_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
enum class FillMethod
{
  Plate = 0,
  Membrane = 1,
  Automatic = 2 // The roughness of the horizon determines smoothing and rim of the plate.
};

struct HoleFillingOptions
{
  /// Holes of more columns stay open.
  std::int64_t LargestHoleSize = 2500;
  FillMethod Method = FillMethod::Automatic;
  /// This is the inverse spring strength that holds the plate to the known columns; 0 interpolates them.
  double RimSmoothing = 1.0;
  int RimWidth = 3; // columns
  /// Columns outside are filled within this number of steps to eight neighbours from a known column.
  int ExtrapolationDistance = 0;
  /// Extrapolated columns must lie in this box.
  std::optional<PlaneBox> Survey = std::nullopt;
};

constexpr int LargestRimWidth = 64;
constexpr double LargestRimSmoothing = 1e6;
constexpr int LargestExtrapolationDistance = 10000;

/// A membrane fills the values; values that are not finite count as unknown.
using PointValue = std::function<double(PointId)>;

struct FilledColumns
{
  std::vector<PlanePoint> Column;
  std::vector<double> Height;
  /// Steps to four neighbours within the hole count; among equally near points the lowest number wins.
  std::vector<PointId> Nearest;
  /// Values are NaN if none is known on the rim.
  std::vector<std::vector<double>> Attribute;
  std::size_t FirstOutside = 0; // the first extrapolated entry
  std::int64_t FilledHoles = 0;
  /// These are too large, or a section has no link to a known column.
  std::int64_t OpenHoles = 0;
  double RimSmoothing = 0.0; // as given or chosen
  int RimWidth = 0;
};

/// `columns` must be distinct (InputError). Columns of holes come first, row by row, then extrapolated columns.
FilledColumns FillHoles(PlanePoints columns, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, const LinkCuts* cuts = nullptr,
  const Monitor& monitor = Monitor());
}

#endif
