// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultInput_h
#define SeismicHorizonsFaultInput_h

#include "Common/Horizon/NamedHorizon.h"
#include "CutoffStage.h"
#include "Filters/Algorithms/Cutoffs/FaultSources.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct GivenFaultPicks
{
  std::optional<PickedSticks> Picks; // none without a dataset
  std::vector<NamedHorizon> Data;
  std::vector<std::string> Warnings;
};

/// Triangles are surfaces, lines sticks. Faults without a name have that of their block.
GivenFaultPicks ReadFaultPicks(std::vector<NamedHorizon> blocks);

struct CutInputs
{
  std::vector<CutInput> Horizons;
  GivenFaultPicks Faults;
  ArrayTable Fields; // of outputs: units and the direction of z
};

/// Without `faults`, those that the horizons are cut by. Throws InputError without a horizon, and if units differ.
CutInputs JoinCutInputs(std::vector<CutInput> horizons, std::optional<std::vector<NamedHorizon>> faults);
CutInputs ReadCutInputs(const std::vector<NamedHorizon>& horizons, std::optional<std::vector<NamedHorizon>> faults);
}

#endif
