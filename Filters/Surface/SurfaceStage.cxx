// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Boundary/BoundaryStage.h"
#include "Filters/Common/CrackData.h"
#include "Filters/Common/CutData.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/LedgerOutput.h"
#include "SeamData.h"

#include <algorithm>
#include <sstream>
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

std::optional<std::int32_t> ToSeam(int row)
{
  CheckAtLeast("seam row", row, -1, ", which stands for none");
  return row < 0 ? std::optional<std::int32_t>() : std::optional<std::int32_t>(row);
}

/// Empty without a lower seam.
std::vector<PointId> FindPointsOn(const std::optional<std::int32_t>& row, PlanePoints columns)
{
  std::vector<PointId> found;
  for (std::size_t point = 0; row && point < columns.size(); ++point)
  {
    if (columns[point].Y == *row)
    {
      found.push_back(PointId(point));
    }
  }
  return found;
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
SeamRows MakeSeams(const SurfaceStageOptions& given)
{
  SeamRows seams;
  seams.Lower = ToSeam(given.SeamRows[0]);
  seams.Upper = ToSeam(given.SeamRows[1]);
  if (HasSeams(seams) && HasErrorTarget(given) && !given.MaximumError)
  {
    throw InputError(
      "a seam and an automatic maximum error, expected one that is given: the noise of a part is not that "
      "of the horizon");
  }
  if (HasSeams(seams) && HasErrorTarget(given) && given.ErrorUnit == HeightUnit::Diagonal)
  {
    throw InputError(
      "a seam and a maximum error of unit Diagonal, expected Lattice or World: the diagonal of a part is "
      "not that of the horizon");
  }
  return seams;
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

/// Parts must agree in parameters that affect seams.
void RequireSame(const Horizon& first, const Horizon& other, const char* name)
{
  const DataArray* const expected = first.FieldData.Find(name);
  const DataArray* const found = other.FieldData.Find(name);
  const std::int64_t size = expected ? expected->Size() : 0;
  for (std::int64_t n = 0; n < size; ++n)
  {
    if (!found || found->Size() != size || found->Value(n) != expected->Value(n))
    {
      std::ostringstream text;
      text << "parts that differ in " << name << " (" << (found ? std::to_string(found->Value(n)) : "none") << " and "
           << expected->Value(n) << "), expected parts of one horizon with the same parameters";
      throw InputError(text.str());
    }
  }
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
  options.Seams = MakeSeams(given);
  const std::optional<LinkCuts> cuts = given.TearAtFaults ? FindCuts(input, PlaneBox(points.Column)) : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  const std::vector<PointId> onLowerSeam = FindPointsOn(options.Seams.Lower, points.Column);
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
    const SharedRows rows{ options.Seams.Lower, options.Seams.Upper };
    WriteLedger(
      points, surface.Kept, CoveredColumns(surface.Mesh.Points.Plane, surface.Mesh.Points.Boundary, 1, rows), mesh);
    if (given.CloseFaults)
    {
      const Reduction& vertices = surface.Mesh.Points;
      CloseMesh(vertices.Plane, points.Lattice, vertices.Boundary, mesh, monitor.Step(0.95, 1.0));
    }
    if (HasSeams(options.Seams))
    {
      WriteSeams(outlines, points.Lattice, surface, options.Seams, onLowerSeam, mesh);
    }
  }
  WriteChosen(surface.Parameters, mesh.FieldData);
  if (limit.Noise)
  {
    WriteHeightNoise(*limit.Noise, mesh.FieldData);
  }
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
void RunSurfaceJoin(std::vector<Horizon> meshes, std::int64_t minimumPatchSize, Horizon& output, const Monitor& monitor)
{
  CheckAtLeast<std::int64_t>("minimum patch size", minimumPatchSize, 1, " point");
  const auto isEmpty = [](const Horizon& mesh)
  { return mesh.NumberOfPoints() == 0 && !mesh.FieldData.Has(FieldArray::SeamRows); };
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(), isEmpty), meshes.end());
  std::stable_sort(meshes.begin(), meshes.end(), // in ascending order of rows
    [](const Horizon& a, const Horizon& b)
    { return FirstValue(a.FieldData, FieldArray::SeamRows) < FirstValue(b.FieldData, FieldArray::SeamRows); });
  std::vector<SurfacePart> parts;
  for (const Horizon& mesh : meshes)
  {
    for (const char* const name : { FieldArray::LatticeToWorld, FieldArray::ChosenRadius,
           FieldArray::ChosenSmallestHoleSize, FieldArray::ChosenDistanceThreshold })
    {
      RequireSame(meshes.front(), mesh, name);
    }
    parts.push_back(ReadSurfacePart(mesh));
    monitor.Progress(0.4 * double(parts.size()) / double(meshes.size()));
  }
  if (!parts.empty())
  {
    const JoinedSurface joined = JoinSurface(parts, minimumPatchSize);
    monitor.Progress(0.8);
    WriteJoinedSurface(meshes, ReadLattice(meshes.front()), joined, output);
  }
}
}
