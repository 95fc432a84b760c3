// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The connected components of a horizon, where points at most k columns apart along each axis are connected (SN_k
// components of the thesis).

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "ColumnRaster.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct PatchComponents
{
  /// For each point the number of its component. Components are numbered in the order in which the rows of the lattice,
  /// from the least y, meet them.
  std::vector<std::int32_t> Component;
  /// For each component its first point in that order, as a place in the raster.
  std::vector<std::int64_t> First;
};

/// Takes time linear in the places of the raster, and in k times the number of runs in its rows.
PatchComponents FindPatchComponents(const ColumnRaster& raster, std::size_t points, int radius);
}

#endif
