// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeHorizon_h
#define SeismicHorizonsLatticeHorizon_h

#include "Common/Base/HeapArray.h"
#include "Common/Horizon/Types.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Parallel arrays with one entry per point, by ascending j, then i, at most one per column.
struct LatticeHorizon
{
  int SurfaceId = 0; // Sheets of a horizon share it.
  HeapArray<PlanePoint> Column;
  HeapArray<int> K; // Vertical index; empty for horizons with z alone.
  HeapArray<double> Thickness; // Thickness and amplitude are of voxels only.
  HeapArray<double> Amplitude;
  HeapArray<double> RealZ; // In the unit and with the sign of the file; finite.
  std::vector<std::pair<std::string, HeapArray<double>>> Attributes;
  std::vector<std::pair<std::string, HeapArray<int>>> Labels; // Means of them would say nothing.
  std::int64_t DroppedDuplicates = 0; // Points dropped for another one in their column.
  std::int64_t DroppedNulls = 0; // Points dropped for lack of z.
};

template <typename Visit>
void ForEachVoxelArray(LatticeHorizon& horizon, Visit&& visit)
{
  visit(horizon.Column);
  visit(horizon.K);
  visit(horizon.Thickness);
  visit(horizon.Amplitude);
  visit(horizon.RealZ);
}
}

#endif
