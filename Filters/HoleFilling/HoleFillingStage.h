// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHoleFillingStage_h
#define SeismicHorizonsHoleFillingStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"

#include <vector>

namespace SeismicHorizons
{
struct HoleFillingStageOptions : HoleFillingOptions
{
  /// Square units of the world; 0: LargestHoleSize alone counts.
  double LargestHoleArea = 0.0;
  bool FillAttributes = true; // Otherwise floating-point attributes of new points are nan.
};

/// Fills the first output, which has the field data.
void RunHoleFilling(
  const Horizon& horizon, HoleFillingStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
