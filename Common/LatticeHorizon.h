// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLatticeHorizon_h
#define SeismicHorizonsLatticeHorizon_h

#include "HeapArray.h"
#include "Types.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// A horizon on a lattice as parallel arrays, one entry per point by ascending j and then i, at most one in a column.
struct LatticeHorizon
{
  int SurfaceId = 0; // sheets of one horizon have the same
  HeapArray<PlanePoint> Column;
  HeapArray<int> K; // the vertical index; empty where horizons come with z alone
  HeapArray<double> Thickness; // this and amplitude are of voxels, and empty for others
  HeapArray<double> Amplitude;
  HeapArray<double> RealZ; // in the unit and with the sign of the file; finite
  std::vector<std::pair<std::string, HeapArray<double>>> Attributes; // others, by name; nan where there is none
  std::int64_t DroppedDuplicates = 0; // left out because another one is in their column
  std::int64_t DroppedNulls = 0; // left out because they have no z
};

/// Calls visit(array) for each array of a horizon of voxels.
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
