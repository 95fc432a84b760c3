// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultStage_h
#define SeismicHorizonsFaultStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/NamedHorizon.h"
#include "FaultWarnings.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Common/HeightUnit.h"

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
  HeightUnit ThrowUnit = HeightUnit::Steps; // of the throw and the noise
  bool AreSticks = false; // Given lines are sticks of faults, and not their traces.
  bool ExtendSticks = false;
  PolygonUse Polygons = PolygonUse::Blank;
};

/// Lines and polygons, which become closed, in world coordinates. Sticks of a fault have the same FaultName in the cell
/// data; without FaultStick, names may end with the number of the stick if all are different. Sticks without a name have
/// that of their block.
std::vector<FaultStick> ReadFaultSticks(const NamedHorizon& block);
std::vector<FaultStick> ReadFaultSticks(const std::vector<NamedHorizon>& blocks);

/// Fills the outputs, which have the field data: the horizon with FaultedLinks, fault lines, and surfaces of sticks.
void RunFaults(const Horizon& horizon, GivenFaults& given, FaultStageOptions options, std::vector<Horizon>& outputs,
  const Monitor& monitor);
}

#endif
