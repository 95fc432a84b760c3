// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceStage.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Boundary/BoundaryStage.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LedgerOutput.h"

#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MeshPort = 0;
constexpr std::size_t OutlinePort = 1;

bool HasErrorTarget(const SurfaceStageOptions& options)
{
  return !options.MaximumNumberOfTriangles;
}

void WriteChosen(const SurfaceParameters& chosen, ArrayTable& figures)
{
  AddValue<int>(figures, FieldArray::ChosenRadius, chosen.Radius);
  AddValue<std::int64_t>(figures, FieldArray::ChosenSmallestHoleSize, std::int64_t(chosen.SmallestHoleSize));
  AddValue<double>(figures, FieldArray::ChosenOutlineTolerance, chosen.OutlineTolerance);
  AddValue<double>(figures, FieldArray::ChosenDistanceThreshold, chosen.DistanceThreshold);
  AddValue<double>(figures, FieldArray::ChosenMaximumError, chosen.MaximumError);
  AddValue<std::int64_t>(figures, FieldArray::ChosenMaximumNumberOfPoints, std::int64_t(chosen.MaximumNumberOfPoints));
}

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
  return options;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunSurface(
  const Horizon& horizon, const SurfaceStageOptions& given, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  std::vector<std::string> warnings;
  RequireAllPoints(horizon);
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon));
  WriteDeviation(points, outputs);
  const Horizon& input = points.Horizon;
  const ErrorLimit limit =
    HasErrorTarget(given) ? FindMaximumError(given, points.Column, points.Height, points.Lattice) : ErrorLimit();
  SurfaceOptions options = MakeSurfaceOptions(given, limit);
  const std::optional<LinkCuts> cuts = given.TearAtFaults ? FindCuts(input, PlaneBox(points.Column)) : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  monitor.Progress(0.1);
  Surface surface = MakeSurface({ points.Column, std::move(points.Height) }, options, monitor.Step(0.1, 0.9));
  Horizon& outlines = outputs[OutlinePort];
  WriteBoundary(
    input, surface.Kept, surface.Boundary, MarkBoundary(BoundaryType::Exterior, {}, surface.Boundary), outlines);
  if (!given.TearAtFaults)
  {
    RemoveCuts(outlines);
  }
  const auto loops =
    surface.Boundary.Boundary.RenumberedBy([&](PointId point) { return surface.Kept[std::size_t(point)]; });
  WriteLedger(points, surface.Kept, CoveredColumns(points.Column, loops, 1), outlines);
  Horizon& mesh = outputs[MeshPort];
  RemoveCuts(mesh); // The cuts of the outlines replace these.
  mesh.FieldData.AddAll(outlines.FieldData);
  if (surface.Kept.empty())
  {
    warnings.push_back(NothingLeft(input, given.MinimumPatchSize));
  }
  else
  {
    ArrayTable& figures = mesh.FieldData;
    AddValue<double>(figures, FieldArray::BoundaryDeviation, surface.BoundaryDeviation);
    AddValue<double>(figures, FieldArray::OutlineDeviation, surface.OutlineDeviation);
    AddValue<double>(figures, FieldArray::OutlineHeightDeviation, surface.OutlineHeightDeviation);
    AddValue<std::int64_t>(figures, FieldArray::NumberOfOutsidePoints, std::int64_t(surface.NumberOutside));
    WriteMesh(outlines, points.Lattice, surface.Mesh, mesh);
    WriteLedger(points, surface.Kept, CoveredColumns(surface.Mesh.Points.Plane, surface.Mesh.Points.Boundary, 1), mesh);
    if (given.CloseFaults)
    {
      const Reduction& vertices = surface.Mesh.Points;
      CloseMesh(vertices.Plane, points.Lattice, vertices.Boundary, mesh, monitor.Step(0.95, 1.0));
    }
  }
  WriteChosen(surface.Parameters, mesh.FieldData);
  if (limit.Noise)
  {
    WriteHeightNoise(*limit.Noise, mesh.FieldData);
  }
  return warnings;
}
}
