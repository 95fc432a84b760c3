// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names given lines that have no effect on a horizon, with the likely cause.

#ifndef SeismicHorizonsFaultWarnings_h
#define SeismicHorizonsFaultWarnings_h

#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Common/LatticePoints.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct IdleLines
{
  std::vector<std::string> Warnings;
  /// Likely, why nothing is cut, where nothing is; empty if unknown.
  std::string Cause;
};

/// Sheets are on the lattice. Names faults of which sticks are in no sheet, and sheets without traces. `traces` are their
/// numbers.
IdleLines FindIdleSticks(const std::vector<FaultStick>& sticks, const std::vector<FaultSheet>& sheets,
  const std::vector<std::size_t>& traces, bool areExtended, const LatticePoints& points);

/// Names lines of which at least half is beside the horizon, on the map.
IdleLines FindIdleLines(
  const std::vector<FaultStick>& lines, const std::vector<FaultPolyline>& onMap, const LatticePoints& points);
}

#endif
