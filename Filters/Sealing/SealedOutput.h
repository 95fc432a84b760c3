// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSealedOutput_h
#define SeismicHorizonsSealedOutput_h

#include "Filters/Algorithms/Sealing/SealedModel.h"
#include "SealedStage.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Names of layers from the top.
std::vector<std::string> NameLayers(const SealedModel& model);

/// As "F1 hanging wall, F2 footwall".
std::string NameBlock(const SealedModel& model, const std::vector<signed char>& sides);

/// Adds all outputs but warnings. Vertices are in the world.
void WriteSealed(const SealedModel& model, const ArrayTable& fields, SealedStageResult& result);
}

#endif
