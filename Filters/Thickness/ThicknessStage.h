// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsThicknessStage_h
#define SeismicHorizonsThicknessStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Survey/LatticeImage.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Fills the first output, which has the field data. Either horizon may be a mesh. Returns warnings.
std::vector<std::string> RunThickness(
  const Horizon& horizon, const Horizon& other, std::vector<Horizon>& outputs, const Monitor& monitor);

/// The output of RunThickness as an image. Throws InputError if steps are not perpendicular, or the map is too large.
LatticeImage MakeThicknessMap(const Horizon& thickness);
}

#endif
