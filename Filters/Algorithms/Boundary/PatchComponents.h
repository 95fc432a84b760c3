// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connected components of a horizon, where points at most k columns apart along each axis are connected (SN_k
// components of the thesis), and the components that are islands inside other outlines.

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Types.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
struct PatchComponents
{
  std::vector<std::int32_t> Component; // by point, numbered row by row from the least y
  std::vector<std::int64_t> First; // places of first points, by component
};

PatchComponents FindPatchComponents(const ColumnIndex& index, std::size_t points, int radius);

/// Calls visit(n, loops around place n). Places must be sorted, and no loop may pass over a place, except the loop that
/// begins there.
void ForEachPlaceInLoops(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places,
  const Loops& loops, const std::function<void(std::size_t, const std::vector<std::size_t>&)>& visit);

/// Assigns each component to the patch whose outline surrounds it, or to itself, also if it is in a hole with a loop.
/// `loops` holds the outlines of all components, then holes, none crossing.
std::vector<std::int32_t> AssignIslands(
  PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& first, const Loops& loops);
}

#endif
