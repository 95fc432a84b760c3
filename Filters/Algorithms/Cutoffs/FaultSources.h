// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks of faults from what there is: sticks, surfaces, or the traces that faults leave in horizons.

#ifndef SeismicHorizonsFaultSources_h
#define SeismicHorizonsFaultSources_h

#include "FaultPlate.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"

#include <array>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct PickedSticks
{
  std::vector<FaultPicks> Faults;
  std::size_t NumberAlone = 0; // sticks that are alone in their fault, which has no surface
  std::vector<std::string> Alone; // such faults, as far as they have names
};

/// A fault for each name, in the order of the first sticks. A closed line is the tip loop of its fault. Throws
/// InputError for a loop without sticks.
PickedSticks PickSticks(const std::vector<FaultStick>& sticks);

using SpaceTriangle = std::array<Eigen::Vector3d, 3>;

FaultPicks PickSurface(const std::string& name, const std::vector<SpaceTriangle>& triangles);

/// Where a fault cuts a horizon, in any order: a place in the middle between columns on both sides, and the way to the
/// lower of both on the map, as long as the throw.
struct TraceCut
{
  Eigen::Vector3d Place;
  Eigen::Vector2d Fall;
  double Gap = 0.0; // map distance without picks
};

/// Traces of one fault in horizons, of which none is empty. Several at different heights give the dip. Else the fault
/// dips by `dip`, in degrees, towards the lower side; 0 takes the gap of the picks as heave, and without a gap the dip
/// is unknown. `column` is the distance of columns, `index` the height of a vertical index.
FaultPicks PickTraces(
  const std::string& name, const std::vector<std::vector<TraceCut>>& traces, double dip, double column, double index);
}

#endif
