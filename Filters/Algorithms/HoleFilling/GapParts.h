// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts that cuts divide a gap into.

#ifndef SeismicHorizonsGapParts_h
#define SeismicHorizonsGapParts_h

#include "Boundary/ColumnRaster.h"
#include "Common/LinkCuts.h"
#include "GapRegion.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// `gap` are the places of the gap in the raster, in their order. Parts are in the order of their first places, and so
/// are the places of each.
std::vector<std::vector<std::int64_t>> SplitGap(
  const ColumnRaster& raster, const RasterFrame& frame, const LinkCuts& cuts, const std::vector<std::int64_t>& gap);
}

#endif
