// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares waveforms of a guided surface: with those of the given picks, and across jumps.

#ifndef SeismicHorizonsGuideLikeness_h
#define SeismicHorizonsGuideLikeness_h

#include "GrowthVote.h"
#include "ReflectionFinder.h"
#include "TraceCube.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Sets likeness and contrast of candidates of the sides. Waveforms reach `halfWidth` samples to each side; `given` picks,
/// by ascending column, are at least one.
void CompareWithGiven(const TraceCube& cube, const ReflectionPicks& picks, const std::vector<PointId>& given,
  int halfWidth, const std::vector<VoteSide>& sides, std::vector<Candidates>& columns);

/// Counts pairs of neighbours along i and j that are more than half a period apart where no fault is: layers around
/// the surface jump along with it at a fault, and continue straight on where it changes the event. `surface` is by
/// column, NoPoint where it is not.
std::int64_t CountSeams(
  const TraceCube& cube, const ReflectionPicks& picks, const std::vector<PointId>& surface, PickDepth quarter);
}

#endif
