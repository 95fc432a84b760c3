// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults that bend the surface over several columns, as in horizons that were smoothed, tracked across a fault, or
// interpolated between lines. No single link has a large step there, and the dip near the fault is the ramp itself.
//
// The rise at a link is the mean height of the columns after it minus the mean of equally many columns before it. It
// has a steep peak at the middle of a ramp, and equals the dip at the shoulders. A fold has a flat peak, which loses
// little half way to the shoulders.

#ifndef SeismicHorizonsFaultRamps_h
#define SeismicHorizonsFaultRamps_h

#include "ColumnHeights.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "FaultForest.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
constexpr int LargestLargestRamp = 10;

/// Returns the rise minus the dip at the shoulders by link of the raster, or NaN. `largest` is the maximum width of a
/// ramp in columns, at least 2.
RawVector<float> FindRises(const ColumnHeights& heights, int largest, const Monitor& monitor);

struct RampLimits
{
  double LeastRise = 0.0;
  double LeastThrow = 0.0;
  double StrongRise = 0.0;
  double StrongThrow = 0.0;
  double LeastStep = 0.0; // of a candidate
  ForestLimits Forest;
};

/// This is the height beyond the link minus the height before it, without the dip.
struct LinkThrow
{
  std::int64_t Link = 0;
  double Throw = 0.0;
};

/// Replaces candidates beside a ramp by a link in its middle, and joins these from row to row. A link with most of the
/// throw stays. Candidates and `throws` are sorted by link; `deviations` are by link of the raster.
std::vector<FaultCandidate> AddRamps(const ColumnHeights& heights, int largest, const RawVector<float>& rises,
  const RawVector<float>& deviations, const RampLimits& limits, std::vector<FaultCandidate> candidates,
  std::vector<LinkThrow>& throws, const Monitor& monitor);
}

#endif
