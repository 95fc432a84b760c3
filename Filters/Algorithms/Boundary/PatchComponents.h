// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The connected components of a horizon, where points at most k columns apart along each axis are connected (SN_k
// components of the thesis).
//
// Which components of a horizon are islands, inside the outlines of others.

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "Common/ColumnIndex.h"
#include "Common/Types.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
struct PatchComponents
{
  /// For each point the number of its component. Components are numbered in the order in which the rows of the lattice,
  /// from the least y, meet them.
  std::vector<std::int32_t> Component;
  /// For each component its first point in that order, as a place in the index.
  std::vector<std::int64_t> First;
};

/// Takes time linear in the places of the index, and in k times the number of runs in its rows.
PatchComponents FindPatchComponents(const ColumnIndex& index, std::size_t points, int radius);

/// Calls visit(n, around) for each of some places, in their order, row by row, with the numbers of the loops that lie
/// around it, in no order. No loop passes over one of the places, but its own may begin there.
void ForEachPlaceInLoops(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places,
  const Loops& loops, const std::function<void(std::size_t, const std::vector<std::size_t>&)>& visit);

/// For each component the one whose patch it belongs to: that in whose outline it lies, unless it lies in a hole with a
/// loop; else itself.
///
/// `first` is the first point of each component, as a place in the index, and components are numbered in the order of
/// these. `loops` are the outlines of all components in their order, and then loops of holes; no two of them cross.
std::vector<std::int32_t> AssignIslands(
  PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& first, const Loops& loops);
}

#endif
