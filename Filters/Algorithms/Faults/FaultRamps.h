// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults that bend the surface over several columns instead of tearing it between two: where a horizon was smoothed,
// tracked across a fault, or interpolated between lines. No single link has a large step there, and the dip near the
// fault is the ramp's own.
//
// The rise at a link is the mean height of the columns after it less that of as many before it. A ramp makes a peak of
// it, which is highest in the middle of the ramp; beyond, at the shoulders, the rise is that of the dip. A fold makes a
// peak as well, but a flat one: half way to the shoulders little is lost. So a peak counts as a ramp when it is steep.

#ifndef SeismicHorizonsFaultRamps_h
#define SeismicHorizonsFaultRamps_h

#include "ColumnHeights.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "FaultForest.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Ramps of more columns are not looked for.
constexpr int LargestLargestRamp = 10;

/// By link of the raster: the rise less that of the dip at the shoulders; nan where too few columns have points.
/// `largest` is how many columns wide a ramp is at most, at least 2.
RawVector<float> FindRises(const ColumnHeights& heights, int largest, const Monitor& monitor);

struct RampLimits
{
  double LeastRise = 0.0; // by noise
  double LeastThrow = 0.0;
  double StrongRise = 0.0;
  double StrongThrow = 0.0;
  double LeastStep = 0.0; // of a candidate
  ForestLimits Forest;
};

/// Height beyond a link less height before it, without the dip.
struct LinkThrow
{
  std::int64_t Link = 0;
  double Throw = 0.0;
};

/// Candidates with a link in the middle of each ramp, instead of those beside it, and with links that join these from
/// row to row. Where most of a ramp is the step across one link, `deviations` of which are by link of the raster, that
/// link stays as it is. Candidates are those of large deviations, by link; so is the result. `throws` becomes those of
/// ramps at their links, by link.
std::vector<FaultCandidate> AddRamps(const ColumnHeights& heights, int largest, const RawVector<float>& rises,
  const RawVector<float>& deviations, const RampLimits& limits, std::vector<FaultCandidate> candidates,
  std::vector<LinkThrow>& throws, const Monitor& monitor);
}

#endif
