// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTriangulationStage_h
#define SeismicHorizonsTriangulationStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct TriangulationStageOptions
{
  SearchStrategy Strategy = SearchStrategy::VoxelTraversal;
  bool ConvexHull = false; // Loops are ignored; triangles outside the limits are removed.
  BoundaryLimits Limits = {};
  std::int64_t MostTriangles = 0; // 0: all
  bool CloseFaults = false;
};

/// Fills both outputs, which have the field data: the mesh, and the search cells of the last triangle.
void RunTriangulation(const Horizon& horizon, const TriangulationStageOptions& options, std::vector<Horizon>& outputs,
  const Monitor& monitor);
}

#endif
