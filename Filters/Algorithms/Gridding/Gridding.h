// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon on the columns of a lattice from picks that stand on none: 2D lines, wells, scattered points.
//
//  - Plate: the thin plate (Briggs 1974) that comes near to all picks where they stand, also between columns; picks
//    nearer than a tenth of a column to each other count as one. Bending is that in the world, whatever the steps. A
//    plane, by least squares, is taken off before and put back, so that picks of a plane give that plane; across picks
//    on a line it is level. Columns that are connected to no pick are left out.
//  - Nearest: the height of the pick nearest to a column, of equally near ones of that with the least x, then y.

#ifndef SeismicHorizonsGridding_h
#define SeismicHorizonsGridding_h

#include "Common/Monitor.h"
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
  /// Columns farther from all picks stay empty, unless they have one, in world units, or where there are no places in
  /// lines; 0: columns outside the convex hull of the picks do.
  double Radius = 0.0;
  /// Of Plate. How much it may differ from picks: the inverse of the strength of the springs between them.
  double Smoothing = 0.01;
  /// Where the lattice comes from: Picks makes one along x and y with about a column for each pick.
  PlacementOptions Placement;
};

constexpr double LargestSmoothing = 1e6;

/// Each horizon by itself, all on one lattice, which begins and ends where picks, and with a radius columns near
/// these, do. Places are x and y, or where there are none the numbers of crosslines and inlines. Of picks at one
/// place the policy says which stays. Attributes are Filled (0 where a pick is in the column, else 1), PickCount (how
/// many are), and PickDistance (from the column to the nearest pick, in world units). The result depends neither on
/// the number of threads nor on the order of picks. Throws InputError on picks without z, options out of their
/// ranges, lattices of more than 1000 columns a pick, and picks far from all others where these are not left out and
/// the lattice is not given, else they are a doubt. Memory is about 600 bytes a column.
SurveyHorizons GridPicks(PickTable picks, const GriddingOptions& options, const Monitor& monitor = Monitor());
}

#endif
