// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the graph of candidates to lines: trees without short branches.

#ifndef SeismicHorizonsFaultForest_h
#define SeismicHorizonsFaultForest_h

#include "CornerGraph.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Which groups and branches are too small for a fault.
struct ForestLimits
{
  int SmallestExtent = 0; // columns
  int SmallestBranch = 0; // links
  int FewestStrong = 0; // candidates of a group
};

/// The candidates, and links that join the end of one to another group: one link between, or two on which the surface
/// steps the same way as where the candidate ends, by at least `least`. step(link) is the height beyond it minus that
/// before it, less the dip; nan where it is not known.
std::vector<FaultCandidate> BridgeEnds(const LinkGrid& grid, std::vector<FaultCandidate> candidates,
  const std::function<float(std::int64_t)>& step, float least);

/// Keeps the maximum spanning forest by the sizes of steps, without trees and branches that are too small.
void KeepForest(CornerGraph& graph, const ForestLimits& limits);

/// A step along a line, and whether the candidate's cut is walked from its first end to its second.
struct ForestStep
{
  std::int32_t Edge = 0;
  bool IsForward = true;
};

/// The kept edges, which are a forest, as lines: the longest way through each tree, then the longest ways that branch
/// off from it.
std::vector<std::vector<ForestStep>> ListLines(const CornerGraph& graph);
}

#endif
