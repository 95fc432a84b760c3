// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps across short gaps. A fault often shows as a band of a few missing columns, where no link has two heights.
// Planes through columns on both sides tell how far apart the two sides are in the middle of the gap.

#ifndef SeismicHorizonsGapSteps_h
#define SeismicHorizonsGapSteps_h

#include "ColumnHeights.h"
#include "Common/Monitor.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Missing columns in a row or file of the lattice between two that are not, as seen by its links: from the first
/// column before the gap to the last one before its end.
struct GapStep
{
  std::int64_t First = 0; // link from the last column before the gap
  std::int64_t Middle = 0; // link in the middle of the gap
  std::int64_t Last = 0; // link to the first column beyond the gap
  double Throw = 0.0; // of the planes, there
  double Height = 0.0; // half way between the planes
};

/// The steps across all gaps of 1 to `longest` columns that are at least `smallest` high, by their links in the middle.
std::vector<GapStep> FindGapSteps(const ColumnHeights& heights, int longest, double smallest, const Monitor& monitor);
}

#endif
