// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names given lines that have no effect on a horizon, with the likely cause.

#ifndef SeismicHorizonsFaultWarnings_h
#define SeismicHorizonsFaultWarnings_h

#include "Common/Horizon/NamedHorizon.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Common/LatticePoints.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// "F1, F2 and 3 more"
std::string ListFaults(const std::vector<std::string>& names);

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

/// Given lines, and which of them have an effect on the horizons so far. Sticks without a name in different blocks belong
/// to different faults.
class GivenFaults
{
public:
  explicit GivenFaults(std::vector<NamedHorizon> blocks = {});

  const std::vector<NamedHorizon> Blocks;
  const std::vector<FaultStick> Sticks;

  bool HaveHorizons() const { return this->Idle.has_value(); }
  void Add(const IdleLines& idle, bool cut);

  /// Of lines without an effect on any horizon.
  std::vector<std::string> Warnings() const;

private:
  bool DoCut = false;
  std::optional<IdleLines> Idle;
};
}

#endif
