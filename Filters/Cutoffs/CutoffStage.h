// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCutoffStage_h
#define SeismicHorizonsCutoffStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/Cutoffs/Cutoffs.h"
#include "Filters/Algorithms/Cutoffs/FaultSources.h"
#include "Filters/Common/HeightUnit.h"
#include "Filters/Common/LatticePoints.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct CutoffStageOptions
{
  double Dip = 0.0; // degrees, for faults of one trace; 0 for that of the gap of picks
  double DropDistance = 0.5; // columns
  double DropNoise = 4.0;
  double LargestGap = 20.0; // columns
  double SmallestLength = 5.0; // columns
  std::optional<double> MaximumError; // Without a value six times the noise of each horizon.
  HeightUnit ErrorUnit = HeightUnit::Steps;
};

/// A horizon and its cutoffs at each fault, which may be none.
struct CutHorizon
{
  std::string Name;
  HorizonPicks Picks;
  double MaximumError = 0.0; // unit of z
  std::vector<HorizonCutoffs> AtFault;
};

struct CutoffModelData
{
  std::vector<FaultPlate> Faults;
  std::vector<CutHorizon> Horizons; // as given
  std::vector<unsigned char> AreTurned; // by fault: the hanging wall of an upright one is on the other side
  std::vector<std::vector<std::size_t>> OnlyHorizons; // FaultPicks::Horizons, by fault
  std::vector<std::string> Warnings;

  /// Of the horizon with the largest columns.
  double LargestStep() const;
};

struct CutInput
{
  std::string Name;
  LatticePoints Points;
};

/// Without filled points, which are no picks. Throws InputError on points without columns, and on simplified meshes.
LatticePoints ReadCutPoints(const Horizon& horizon);

/// Without `given` faults, the cuts of the horizons are the faults: those of one name in several horizons are one, apart
/// from the names of detected ones. Throws InputError without faults, or if none cuts a horizon.
CutoffModelData RunCutoffs(const std::vector<CutInput>& horizons, const std::optional<PickedSticks>& given,
  const CutoffStageOptions& options, const Monitor& monitor);
}

#endif
