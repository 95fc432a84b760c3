// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonVoxels_h
#define SeismicHorizonsHorizonVoxels_h

#include "HeapArray.h"
#include "Types.h"

#include <cstdint>

namespace SeismicHorizons
{
/// A horizon as parallel arrays, one entry per voxel by ascending j and then i, at most one voxel per column.
struct HorizonVoxels
{
  int SurfaceId = 0;
  HeapArray<PlanePoint> Column;
  HeapArray<int> K;
  HeapArray<double> Thickness;
  HeapArray<double> Amplitude;
  HeapArray<double> RealZ;
  std::int64_t DroppedDuplicates = 0;
};

/// Calls visit(array) for each array of a horizon.
template <typename Visit>
void ForEachVoxelArray(HorizonVoxels& horizon, Visit&& visit)
{
  visit(horizon.Column);
  visit(horizon.K);
  visit(horizon.Thickness);
  visit(horizon.Amplitude);
  visit(horizon.RealZ);
}
}

#endif
