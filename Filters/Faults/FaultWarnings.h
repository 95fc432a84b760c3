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
/// Given lines without an effect on a horizon, or on any of several.
struct IdleLines
{
  std::size_t Given = 0; // sticks, or traces
  std::size_t Sheets = 0;
  std::size_t SticksAlone = 0; // in no sheet
  std::vector<std::string> FaultsAlone; // of these
  std::vector<std::string> Uncut; // faults of sheets without traces
  std::vector<std::string> Beside; // lines of which at least half is beside the horizon, on the map
  /// Likely, why nothing is cut; empty if unknown.
  std::string Cause;

  /// Keeps what has no effect on another horizon either.
  void KeepCommon(const IdleLines& other);

  std::vector<std::string> Warnings() const;
};

/// Sheets are on the lattice. `traces` are the numbers of their traces.
IdleLines FindIdleSticks(const std::vector<FaultStick>& sticks, const std::vector<FaultSheet>& sheets,
  const std::vector<std::size_t>& traces, bool areExtended, const LatticePoints& points);

IdleLines FindIdleLines(
  const std::vector<FaultStick>& lines, const std::vector<FaultPolyline>& onMap, const LatticePoints& points);
}

#endif
