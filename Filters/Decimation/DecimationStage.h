// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDecimationStage_h
#define SeismicHorizonsDecimationStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Common/HeightUnit.h"
#include "Filters/Common/ReducedHorizon.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// What meshes of fewer points have in common.
struct ReducedMeshOptions : DecimationQuality
{
  std::optional<double> MaximumError; // Without a value six times the noise of the heights.
  HeightUnit ErrorUnit = HeightUnit::Steps;
  bool CloseFaults = false;
};

enum class DecimationTarget
{
  LargestError,
  NumberOfPoints,
  Reduction
};

struct DecimationStageOptions : ReducedMeshOptions
{
  DecimationTarget Target = DecimationTarget::LargestError;
  std::int64_t MaximumNumberOfPoints = 10000;
  double TargetReduction = 0.95;
};

/// Fills the first output, which has the field data.
void RunDecimation(
  const Horizon& horizon, const DecimationStageOptions& options, std::vector<Horizon>& outputs, const Monitor& monitor);

/// An automatic limit is chosen from the points.
ErrorLimit FindMaximumError(
  const ReducedMeshOptions& options, PlanePoints columns, const std::vector<double>& height, const Lattice& lattice);

/// Throws InputError below 0.
void CheckMaximumError(double error);

/// Writes vertices, triangles and figures. Moves the triangles out of the decimation.
void WriteMesh(const Horizon& input, const Lattice& lattice, Decimation& decimation, Horizon& output);

/// The same for input points in parts: `nearest` has the source of each vertex.
void WriteMesh(
  const Horizon& nearest, const MergedParts& merged, const Lattice& lattice, Decimation& decimation, Horizon& output);
}

#endif
