// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsJuxtapositionOutput_h
#define SeismicHorizonsJuxtapositionOutput_h

#include "Common/Horizon/Horizon.h"
#include "CutoffStage.h"
#include "Filters/Algorithms/Cutoffs/Juxtaposition.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Areas of a fault by the layers that meet there. Horizons are those that it cuts, the uppermost first.
struct FaultJuxtaposition
{
  std::vector<const CutHorizon*> Horizons;
  std::vector<MetArea> Areas;
};

FaultJuxtaposition JuxtaposeAt(const CutoffModelData& model, std::size_t fault);

/// Such as "A to B".
std::string NameOf(const MetLayer& layer, const std::vector<const CutHorizon*>& horizons);

/// On the faults, or as diagrams side by side: distance along strike, and height.
Horizon WriteJuxtaposition(
  const std::vector<FaultPlate>& faults, const std::vector<FaultJuxtaposition>& juxtapositions, bool areDiagrams);
}

#endif
