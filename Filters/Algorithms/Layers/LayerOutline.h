// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outlines of a stack, of the fewest points for which all its horizons are within the error along them.

#ifndef SeismicHorizonsLayerOutline_h
#define SeismicHorizonsLayerOutline_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/ColumnIndex.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
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
  std::vector<PointId> Fixed; // points that stay, besides the ends of cracks
};

/// Of points that all have a patch, with the heights of each horizon. `known` has for each of these 1 where its height
/// counts; it is empty where all do. What horizons have in columns without a point counts where outlines pass over it;
/// `indices` are of their columns.
LayerOutline SimplifyOutline(PlanePoints columns, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const std::vector<HorizonView>& horizons,
  const std::vector<ColumnIndex>& indices, const ExteriorBoundary& boundary, const LayerOutlineOptions& options,
  const Monitor& monitor);
}

#endif
