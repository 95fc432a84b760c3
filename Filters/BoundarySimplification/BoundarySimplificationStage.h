// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsBoundarySimplificationStage_h
#define SeismicHorizonsBoundarySimplificationStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"

#include <vector>

namespace SeismicHorizons
{
/// Fills the first output, which has the field data.
void RunBoundarySimplification(
  const Horizon& horizon, BoundarySimplificationOptions options, std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
