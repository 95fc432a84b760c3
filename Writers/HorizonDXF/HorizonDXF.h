// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonDXF_h
#define SeismicHorizonsHorizonDXF_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"

#include <ostream>
#include <vector>

namespace SeismicHorizons
{
/// Each horizon, a mesh, is a layer.
void PrintDXF(const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor);
}

#endif
