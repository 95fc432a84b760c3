// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceFigures.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Common/CrackData.h"

namespace SeismicHorizons
{
namespace
{
void WriteChosen(const SurfaceParameters& chosen, ArrayTable& figures)
{
  AddValue<int>(figures, FieldArray::ChosenRadius, chosen.Radius);
  AddValue<std::int64_t>(figures, FieldArray::ChosenSmallestHoleSize, std::int64_t(chosen.SmallestHoleSize));
  AddValue<double>(figures, FieldArray::ChosenOutlineTolerance, chosen.OutlineTolerance);
  AddValue<double>(figures, FieldArray::ChosenDistanceThreshold, chosen.DistanceThreshold);
  AddValue<double>(figures, FieldArray::ChosenMaximumError, chosen.MaximumError);
  AddValue<std::int64_t>(figures, FieldArray::ChosenMaximumNumberOfPoints, std::int64_t(chosen.MaximumNumberOfPoints));
}
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceOptions MakeSurfaceOptions(const SurfaceStageOptions& given, const ErrorLimit& limit)
{
  SurfaceOptions options;
  static_cast<DecimationQuality&>(options) = given;
  if (HasErrorTarget(given))
  {
    options.MaximumError = limit.Indices;
  }
  else
  {
    CheckAtLeast<std::int64_t>("maximum number of triangles", *given.MaximumNumberOfTriangles, 1, "");
    options.MaximumNumberOfTriangles = std::size_t(*given.MaximumNumberOfTriangles);
  }
  options.Radius = given.Radius;
  options.Growth = given.Growth;
  options.KeepHoles = given.KeepHoles;
  options.SmallestHoleSize = given.SmallestHoleSize;
  options.MinimumPatchSize = given.MinimumPatchSize;
  options.OutlineTolerance = given.OutlineTolerance;
  options.DistanceThreshold = given.DistanceThreshold;
  options.RowsOfPart = given.RowsOfPart;
  options.Ranks = given.Ranks;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDeviations(const Surface& surface, ArrayTable& figures)
{
  AddValue<double>(figures, FieldArray::BoundaryDeviation, surface.BoundaryDeviation);
  AddValue<double>(figures, FieldArray::OutlineDeviation, surface.OutlineDeviation);
  AddValue<double>(figures, FieldArray::OutlineHeightDeviation, surface.OutlineHeightDeviation);
  AddValue<std::int64_t>(figures, FieldArray::NumberOfOutsidePoints, std::int64_t(surface.NumberOutside));
}

//----------------------------------------------------------------------------------------------------------------------
void CloseIfWanted(const SurfaceStageOptions& given, const Lattice& lattice, const Reduction& vertices,
  const Monitor& monitor, Horizon& mesh)
{
  if (given.CloseFaults)
  {
    CloseMesh(vertices.Plane, lattice, vertices.Boundary, mesh, monitor.Step(0.95, 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteParameters(const SurfaceParameters& chosen, const ErrorLimit& limit, ArrayTable& figures)
{
  WriteChosen(chosen, figures);
  if (limit.Noise)
  {
    WriteHeightNoise(*limit.Noise, figures);
  }
}
}
