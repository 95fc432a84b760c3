// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCutoffTables_h
#define SeismicHorizonsCutoffTables_h

#include "Common/Horizon/DataArray.h"
#include "CutoffStage.h"
#include "JuxtapositionOutput.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A row per horizon and fault that cuts it.
ArrayTable WriteCutoffTable(const CutoffModelData& model);

/// A row per fault and pair of layers.
ArrayTable WriteAreaTable(const CutoffModelData& model, const std::vector<FaultJuxtaposition>& juxtapositions);

std::string ReportCutoffs(const CutoffModelData& model);
}

#endif
