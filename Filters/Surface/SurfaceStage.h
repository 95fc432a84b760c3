// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfaceStage_h
#define SeismicHorizonsSurfaceStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Decimation/DecimationStage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
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
};

/// Fills both outputs, which have the field data: the mesh, and the outlines with all points. Returns warnings.
std::vector<std::string> RunSurface(
  const Horizon& horizon, const SurfaceStageOptions& options, std::vector<Horizon>& outputs, const Monitor& monitor);

/// The points of a horizon that is not in memory, as readers make them.
class HorizonRows
{
public:
  virtual ~HorizonRows() = default;
  /// The columns of all points; empty without any.
  virtual PlaneBox Box() const = 0;
  virtual std::int64_t CountPoints(std::int32_t firstRow, std::int32_t lastRow) const = 0;
  /// Returns the points of these rows, row by row. In the field data, duplicates and the ledger are those of these rows.
  virtual Horizon Read(std::int32_t firstRow, std::int32_t lastRow) const = 0;
};

/// Fills the same mesh as of the points in memory. Throws InputError if the horizon must be meshed at once and has more
/// than `mostAtOnce` points. Returns warnings.
std::vector<std::string> RunSurfaceByRows(const HorizonRows& rows, const SurfaceStageOptions& options,
  std::int64_t mostAtOnce, Horizon& mesh, const Monitor& monitor);
}

#endif
