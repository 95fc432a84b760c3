// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCellSimplificationStage_h
#define SeismicHorizonsCellSimplificationStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Both fill the first output, which has the field data, with the points, or with cells as wireframe if the options list
/// them. At most `most` points are left, for which options are chosen; 0 leaves the options as they are.
void RunRoughSimplification(const Horizon& horizon, CellOptions options, std::int64_t most,
  std::vector<Horizon>& outputs, const Monitor& monitor);
void RunElaborateSimplification(const Horizon& horizon, ElaborateOptions options, std::int64_t most,
  std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
