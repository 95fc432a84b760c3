// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceStage.h"

#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Boundary/BoundaryStage.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LedgerOutput.h"
#include "SurfaceFigures.h"

#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MeshPort = 0;
constexpr std::size_t OutlinePort = 1;
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
    warnings.push_back(NothingLeft(input.NumberOfPoints(), given.MinimumPatchSize));
  }
  else
  {
    WriteDeviations(surface, mesh.FieldData);
    WriteMesh(outlines, points.Lattice, surface.Mesh, mesh);
    WriteLedger(points, surface.Kept, CoveredColumns(surface.Mesh.Points.Plane, surface.Mesh.Points.Boundary, 1), mesh);
    CloseIfWanted(given, points.Lattice, surface.Mesh.Points, monitor, mesh);
  }
  WriteParameters(surface.Parameters, limit, mesh.FieldData);
  return warnings;
}
}
