// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsBoundaryStage_h
#define SeismicHorizonsBoundaryStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/KeptPoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct BoundaryStageOptions : BoundaryOptions
{
  BoundaryType Type = BoundaryType::Exterior;
  /// Square units of the world; the larger one of both sizes counts.
  double SmallestHoleArea = 0.0;
  bool TearAtFaults = true; // Faulted links split the horizon. Otherwise the output has none.
};

/// Fills the first output, which has the field data. Returns warnings.
std::vector<std::string> RunBoundary(
  const Horizon& horizon, BoundaryStageOptions options, std::vector<Horizon>& outputs, const Monitor& monitor);

/// Output points keep their order and arrays, which are shared if all points are kept. `boundary` numbers the kept
/// points.
void WriteBoundary(const Horizon& input, const KeptPoints& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, Horizon& output);

void WriteBoundaryFigures(const ExteriorBoundary& boundary, std::int64_t droppedPoints, ArrayTable& figures);

/// Also removes the cracks along faulted links.
void RemoveCuts(Horizon& output);

/// Returns the warning for a horizon without a patch of `minimumPatchSize` points.
std::string NothingLeft(std::int64_t numberOfPoints, std::int64_t minimumPatchSize);
}

#endif
