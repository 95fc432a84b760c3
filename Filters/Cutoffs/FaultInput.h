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

/// The field data of outputs: units and the direction of z. Throws InputError if those of the horizons differ, or of the
/// faults.
ArrayTable JoinFields(const std::vector<CutInput>& horizons, GivenFaultPicks& given);
}

#endif
