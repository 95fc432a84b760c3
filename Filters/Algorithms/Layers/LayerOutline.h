// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outlines of a stack with the fewest points for which all horizons are within the error along them.

#ifndef SeismicHorizonsLayerOutline_h
#define SeismicHorizonsLayerOutline_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "OrderedStack.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LayerOutline
{
  Loops Boundary;
  std::vector<std::int32_t> Patch; // by point: NoPatch for those outside
};

struct LayerOutlineOptions
{
  double MaximumError = 0.0; // lattice units
  double Tolerance = 0.0; // columns
  std::vector<PointId> Fixed; // in addition to the ends of cracks
};

/// `known` has 1 where heights count, or is empty. Points of `horizons` in other columns count below outlines.
LayerOutline SimplifyOutline(PlanePoints columns, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const std::vector<HorizonView>& horizons,
  const std::vector<ColumnIndex>& indices, const ExteriorBoundary& boundary, const LayerOutlineOptions& options,
  const Monitor& monitor);
}

#endif
