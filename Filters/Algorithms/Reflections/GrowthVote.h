// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decides, region by region, where surfaces of a guide made in two ways disagree.

#ifndef SeismicHorizonsGrowthVote_h
#define SeismicHorizonsGrowthVote_h

#include "ReflectionFinder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
enum class VoteSide : std::uint8_t
{
  Parts, // of automatic surfaces, and growth around them
  Growth, // from the given picks alone
  None // the column stays empty
};

struct Candidate
{
  PointId Pick = NoPoint;
  float Likeness = 0.0F; // largest correlation with the nearest given picks, -1 to 1
  float Contrast = 0.0F; // absolute logarithm of the ratio of its strength to that of the nearest given pick
  bool IsPart = false; // of an automatic surface
  bool IsGiven = false; // of both sides; strays are of Growth alone
};

/// By VoteSide.
using Candidates = std::array<Candidate, 2>;

/// Candidates are by column. They agree if they are within `quarter`, a quarter of the dominant period. Where they
/// agree, the side is Parts.
std::vector<VoteSide> VoteByRegions(
  const ReflectionPicks& picks, const std::vector<Candidates>& columns, PickDepth quarter);
}

#endif
