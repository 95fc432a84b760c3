// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids picks between columns: 2D lines, wells, scattered points.
//
// - Plate: a thin plate (Briggs 1974), bent in world units, near all picks. A least-squares plane is taken off first,
// so that picks of a plane give that plane; across picks on a line it is level.
// - Nearest: the z of the nearest pick; of equally near picks, of least x, then y.
//
// Attributes are Filled (1 in columns without a pick, 2 outside the convex hull of picks), PickCount, and
// PickDistance to the nearest pick, in world units.

#ifndef SeismicHorizonsGridding_h
#define SeismicHorizonsGridding_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/PlacementOptions.h"
#include "Common/Survey/SurveyHorizons.h"

namespace SeismicHorizons
{
enum class GriddingMethod
{
  Plate,
  Nearest
};

struct GriddingOptions
{
  GriddingMethod Method = GriddingMethod::Plate;
  /// Columns without picks stay empty beyond it, in world units or line numbers; 0 limits to the convex hull.
  double Radius = 0.0;
  /// Springs of the inverse strength hold the plate to picks.
  double Smoothing = 0.01;
  /// The source Picks makes a lattice along x and y with about a column per pick.
  PlacementOptions Placement;
};

constexpr double LargestSmoothing = 1e6;

/// One lattice ends at the picks of all horizons, or at their radius. Throws InputError on picks without z, above 1000
/// columns per pick, and on distant picks, unless left out or the lattice is given. Takes 600 bytes per column.
SurveyHorizons GridPicks(PickTable picks, const GriddingOptions& options, const Monitor& monitor = Monitor());
}

#endif
