// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfaceStage_h
#define SeismicHorizonsSurfaceStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Decimation/DecimationStage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class PartRanks;

/// Parameters without a value are chosen.
struct SurfaceStageOptions : ReducedMeshOptions
{
  std::optional<std::int64_t> MaximumNumberOfTriangles; // the target in place of the error
  std::optional<int> Radius;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  bool KeepHoles = true;
  bool TearAtFaults = true; // Faulted links split the horizon. Otherwise outputs have none.
  std::optional<std::int64_t> SmallestHoleSize;
  std::int64_t MinimumPatchSize = 1;
  std::optional<double> OutlineTolerance;
  std::optional<double> DistanceThreshold;
  std::int32_t RowsOfPart = 0; // Chosen if 0; others are for tests.
  const PartRanks* Ranks = nullptr; // which mesh a large horizon together
};

/// Fills both outputs, which have the field data: the mesh, and the outlines with all points. Returns warnings.
std::vector<std::string> RunSurface(
  const Horizon& horizon, const SurfaceStageOptions& options, std::vector<Horizon>& outputs, const Monitor& monitor);
}

#endif
