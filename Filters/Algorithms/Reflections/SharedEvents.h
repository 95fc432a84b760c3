// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decides which guides keep picks that surfaces of several of them have. Horizons meet where layers pinch out, but growth
// also runs into events of others, across faults above all.

#ifndef SeismicHorizonsSharedEvents_h
#define SeismicHorizonsSharedEvents_h

#include "GuidedJoining.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Picks that two surfaces, the lower number first, have both.
using SharedCounts = std::map<std::pair<std::size_t, std::size_t>, std::int64_t>;

/// Removes picks from surfaces. Their order makes no difference. Returns what is still shared.
SharedCounts SettleSharedEvents(
  const ReflectionPicks& picks, const GrowthLinks& links, const std::vector<GuidedSurface*>& surfaces);
}

#endif
