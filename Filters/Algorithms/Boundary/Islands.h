// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which components of a horizon are islands, inside the outlines of others.

#ifndef SeismicHorizonsIslands_h
#define SeismicHorizonsIslands_h

#include "ColumnRaster.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// For each component the one whose patch it belongs to: that in whose outline it lies, unless it lies in a hole with a
/// loop; else itself.
///
/// `first` is the first point of each component, as a place in the raster, and components are numbered in the order of
/// these. `loops` are the outlines of all components in their order, and then loops of holes; no two of them cross.
std::vector<std::int32_t> AssignIslands(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const std::vector<std::int64_t>& first, const Loops& loops);
}

#endif
