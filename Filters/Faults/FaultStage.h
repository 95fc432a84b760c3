// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultStage_h
#define SeismicHorizonsFaultStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "FaultWarnings.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Common/HeightUnit.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SeismicHorizons
{
enum class PolygonUse
{
  Blank, // leave out points inside
  Cut,
  Leave // ignore polygons
};

struct FaultStageOptions : FaultDetectionOptions
{
  bool Detect = true;
  HeightUnit ThrowUnit = HeightUnit::Lattice; // of the throw and the noise
  bool AreSticks = false; // Given lines are sticks of faults, and not their traces.
  bool ExtendSticks = false;
  PolygonUse Polygons = PolygonUse::Blank;
};

/// Lines and polygons, which become closed, in world coordinates. Sticks of a fault have the same FaultName in the cell
/// data; without FaultStick, apart from its last word, the number of the stick.
std::vector<FaultStick> ReadFaultSticks(const Horizon& lines);

struct FaultOutcome
{
  bool Cuts = false; // A given line cuts or blanks points.
  IdleLines Idle;
};

/// Fills the outputs, which have the field data: the horizon with FaultedLinks, fault lines, and the surfaces of sticks.
FaultOutcome RunFaults(const Horizon& horizon, const std::vector<FaultStick>& given, FaultStageOptions options,
  std::vector<Horizon>& outputs, const Monitor& monitor);

/// If none of some lines cuts any horizon. The cause may be empty.
std::vector<std::string> WarnOfIdleLines(std::size_t lines, const std::string& cause);
}

#endif
