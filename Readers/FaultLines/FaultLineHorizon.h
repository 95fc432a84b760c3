// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLineHorizon_h
#define SeismicHorizonsFaultLineHorizon_h

#include "Common/Horizon/Horizon.h"
#include "Common/Survey/LatticeFrame.h"
#include "FaultLineFile.h"

#include <optional>

namespace SeismicHorizons
{
/// A polyline per line of the file. Without a direction, z increases upwards if none is positive. Files may say theirs.
Horizon MakeFaultLines(const FaultLineFile& file, std::optional<VerticalDirection> direction);
}

#endif
