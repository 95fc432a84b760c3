// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCutTraces_h
#define SeismicHorizonsCutTraces_h

#include "CutoffStage.h"

#include <vector>

namespace SeismicHorizons
{
/// Faults that the cuts of horizons give, each for the horizons that it cuts.
std::vector<FaultPicks> PickCuts(const std::vector<CutInput>& horizons, const CutoffStageOptions& options);
}

#endif
