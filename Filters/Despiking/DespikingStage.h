// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDespikingStage_h
#define SeismicHorizonsDespikingStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Common/HeightUnit.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct DespikingStageOptions : DespikingOptions
{
  HeightUnit ThresholdUnit = HeightUnit::Steps;
  bool Remove = true; // Otherwise the array Spike marks points.
};

/// Fills the output, which has the field data, and the spikes if there is a second output. Returns warnings.
std::vector<std::string> RunDespiking(
  const Horizon& horizon, DespikingStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
