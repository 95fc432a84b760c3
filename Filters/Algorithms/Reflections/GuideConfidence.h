// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far picks of a guided surface can be trusted, and which given picks they rest on.

#ifndef SeismicHorizonsGuideConfidence_h
#define SeismicHorizonsGuideConfidence_h

#include "GrowthVote.h"
#include "GuidedJoining.h"
#include "ReflectionFinder.h"

#include <vector>

namespace SeismicHorizons
{
/// Returns the probability that a pick is on the event of the given picks: about this fraction of such picks is within
/// half a period. `surface` is by column, `quarter` is a quarter of the dominant period.
std::vector<float> MeasureConfidence(
  const ReflectionPicks& picks, const std::vector<Candidate>& surface, PickDepth quarter);

/// Sets blocks, within which the surface does not jump by more than half a period, from 1, the largest first, and the
/// number of the given pick that is nearest along the block.
void FindBlocks(const ReflectionPicks& picks, PickDepth quarter, GuidedSurface& surface);
}

#endif
