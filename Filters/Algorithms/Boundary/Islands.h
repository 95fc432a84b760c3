// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which components of a horizon are islands, inside the outlines of others.

#ifndef SeismicHorizonsIslands_h
#define SeismicHorizonsIslands_h

#include "ColumnRaster.h"
#include "Common/Types.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Calls visit(n, around) for each of some places, in their order, row by row, with the numbers of the loops that lie
/// around it, in no order. No loop passes over one of the places, but its own may begin there.
void ForEachPlaceInLoops(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const std::vector<std::int64_t>& places, const Loops& loops,
  const std::function<void(std::size_t, const std::vector<std::size_t>&)>& visit);

/// For each component the one whose patch it belongs to: that in whose outline it lies, unless it lies in a hole with a
/// loop; else itself.
///
/// `first` is the first point of each component, as a place in the raster, and components are numbered in the order of
/// these. `loops` are the outlines of all components in their order, and then loops of holes; no two of them cross.
std::vector<std::int32_t> AssignIslands(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const std::vector<std::int64_t>& first, const Loops& loops);
}

#endif
