// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decides which guides keep picks that surfaces of several of them have. Horizons meet where layers pinch out, but growth
// also runs into events of others, across faults above all.

#ifndef SeismicHorizonsSharedEvents_h
#define SeismicHorizonsSharedEvents_h

#include "GuidedJoining.h"

#include <vector>

namespace SeismicHorizons
{
/// Removes picks from surfaces. Their order makes no difference.
void SettleSharedEvents(
  const ReflectionPicks& picks, const GrowthLinks& links, const std::vector<GuidedSurface*>& surfaces);
}

#endif
