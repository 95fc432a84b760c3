// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTSurfHorizon_h
#define SeismicHorizonsTSurfHorizon_h

#include "Common/Horizon/Horizon.h"
#include "Common/Survey/TSurf.h"
#include "TSurfParser.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Arrays are described in Documentation/GOCADTSurf.md. If z of the file increases downwards, triangles are
/// reversed with it and keep their orientation.
Horizon MakeTSurfHorizon(TSurf surface);

std::vector<std::string> NamesOf(const TSurfList& list);

/// Where z grows to, and why.
std::string DescribeSense(const std::vector<TSurf>& surfaces);
}

#endif
