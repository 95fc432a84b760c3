// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grows surfaces from picks, best link first (Prim 1957).

#ifndef SeismicHorizonsPlainGrowth_h
#define SeismicHorizonsPlainGrowth_h

#include "Common/Base/RawVector.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct GrownPicks
{
  std::vector<PointId> Picks; // by column, NoPoint at starts and where nothing grew
  std::vector<std::int32_t> Stops; // columns just beyond the reach
};

struct GrowthRules
{
  double SmallestCorrelation = 0.6; // of waveforms
  int Reach = 0; // in columns
  /// By column; without them the reach counts columns on the way from starts.
  const std::vector<int>* Distances = nullptr;
  /// Growth also prefers small steps, and does not enter picks of very different strength.
  bool IsCareful = false;
};

/// `columns` are those of picks, `starts` are by column. All starts grow at once, so that growth from two sides stops
/// where it meets.
GrownPicks GrowPlainly(const ReflectionPicks& picks, const RawVector<std::int32_t>& columns, const GrowthLinks& links,
  const std::vector<PointId>& starts, const GrowthRules& rules);
}

#endif
