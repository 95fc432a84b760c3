// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSealedWarnings_h
#define SeismicHorizonsSealedWarnings_h

#include "Filters/Algorithms/Sealing/FaultNetwork.h"
#include "Filters/Algorithms/Sealing/SealedModel.h"
#include "Filters/Cutoffs/CutoffStage.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// What was chosen, guessed, moved or left out.
std::vector<std::string> WarnOfSealed(const SealedModel& model, const FaultNetwork& network, const SealingInput& input,
  const CutoffModelData& cutoffs, double error);
}

#endif
