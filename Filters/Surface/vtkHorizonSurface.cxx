// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurface.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/PipelineRequest.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Boundary/BoundaryOutput.h"
#include "Filters/Marshalling/CrackData.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "Filters/Marshalling/LedgerOutput.h"
#include "SeamData.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <optional>
#include <string>
#include <utility>

using namespace SeismicHorizons;

namespace
{
constexpr std::size_t MeshPort = 0;
constexpr std::size_t OutlinePort = 1;

template <typename Value, typename Given>
std::optional<Value> UnlessAutomatic(bool isAutomatic, Given value)
{
  return isAutomatic ? std::nullopt : std::optional<Value>(value);
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

void WriteChosen(const SurfaceParameters& chosen, vtkFieldData* figures)
{
  AddValue<vtkIntArray>(figures, FieldArray::ChosenRadius, chosen.Radius);
  AddValue<vtkIdTypeArray>(figures, FieldArray::ChosenSmallestHoleSize, vtkIdType(chosen.SmallestHoleSize));
  AddValue<vtkDoubleArray>(figures, FieldArray::ChosenOutlineTolerance, chosen.OutlineTolerance);
  AddValue<vtkDoubleArray>(figures, FieldArray::ChosenDistanceThreshold, chosen.DistanceThreshold);
  AddValue<vtkDoubleArray>(figures, FieldArray::ChosenMaximumError, chosen.MaximumError);
  AddValue<vtkIdTypeArray>(figures, FieldArray::ChosenMaximumNumberOfPoints, vtkIdType(chosen.MaximumNumberOfPoints));
}
}

vtkStandardNewMacro(vtkHorizonSurface);

//------------------------------------------------------------------------------
vtkHorizonSurface::vtkHorizonSurface()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
SeismicHorizons::SeamRows vtkHorizonSurface::MakeSeams()
{
  SeismicHorizons::SeamRows seams;
  seams.Lower = ToSeam(this->SeamRows[0]);
  seams.Upper = ToSeam(this->SeamRows[1]);
  if (HasSeams(seams) && this->Target == LargestError && this->IsErrorAutomatic())
  {
    throw InputError(
      "a seam and an automatic maximum error, expected one that is given: the noise of a part is not that "
      "of the horizon");
  }
  if (HasSeams(seams) && this->Target == LargestError && this->GetErrorUnit() == Diagonal)
  {
    throw InputError(
      "a seam and a maximum error of unit Diagonal, expected Lattice or World: the diagonal of a part is "
      "not that of the horizon");
  }
  return seams;
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::Choose(vtkPolyData* horizon, const std::function<void(const LatticePoints&)>& choose)
{
  RunRequest(this, {}, NotEnoughMemory,
    [&](std::string&, const Monitor&)
    {
      if (horizon && horizon->GetNumberOfPoints() > 0)
      {
        CheckArraySizes(horizon);
        choose(ReadColumns(WithoutHiddenPoints(horizon), {}));
      }
    });
}

//------------------------------------------------------------------------------
int vtkHorizonSurface::ChooseRadius(vtkPolyData* horizon)
{
  int radius = 0;
  this->Choose(horizon, [&](const LatticePoints& points) { radius = SeismicHorizons::ChooseRadius(points.Column); });
  return radius;
}

//------------------------------------------------------------------------------
double vtkHorizonSurface::ChooseMaximumError(vtkPolyData* horizon, vtkFieldData* figures)
{
  HeightNoise noise;
  this->Choose(horizon, [&](const LatticePoints& points) { noise = MeasureHeightNoise(points.Column, points.Height); });
  if (figures)
  {
    WriteHeightNoise(noise, figures);
  }
  return noise.MaximumError();
}

//------------------------------------------------------------------------------
SurfaceOptions vtkHorizonSurface::MakeOptions(const ErrorLimit& limit) const
{
  SurfaceOptions options;
  static_cast<DecimationQuality&>(options) = this->MakeQuality();
  if (this->Target == LargestError)
  {
    options.MaximumError = limit.Indices;
  }
  else
  {
    CheckAtLeast("maximum number of triangles", this->MaximumNumberOfTriangles, 1, "");
    options.MaximumNumberOfTriangles = std::size_t(this->MaximumNumberOfTriangles);
  }
  options.Radius = UnlessAutomatic<int>(this->AutomaticRadius, this->Radius);
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.HoleBoundaries = this->HoleBoundaries;
  options.SmallestHoleSize = UnlessAutomatic<std::int64_t>(this->AutomaticSmallestHoleSize, this->SmallestHoleSize);
  options.MinimumPatchSize = this->MinimumPatchSize;
  options.OutlineTolerance = UnlessAutomatic<double>(this->AutomaticOutlineTolerance, this->OutlineTolerance);
  options.DistanceThreshold = UnlessAutomatic<double>(this->AutomaticDistanceThreshold, this->DistanceThreshold);
  return options;
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  RequireAllPoints(horizon);
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const input = points.Horizon;
  const ErrorLimit limit =
    this->Target == LargestError ? this->FindMaximumError(points.Column, points.Height, points.Lattice) : ErrorLimit();
  SurfaceOptions options = this->MakeOptions(limit);
  options.Seams = this->MakeSeams();
  const std::optional<LinkCuts> cuts = this->UseCuts ? FindCuts(input, PlaneBox(points.Column)) : std::nullopt;
  options.Cuts = cuts ? &*cuts : nullptr;
  const std::vector<PointId> onLowerSeam = FindPointsOn(options.Seams.Lower, points.Column);
  monitor.Progress(0.1);
  Surface surface = MakeSurface({ points.Column, std::move(points.Height) }, options, monitor.Step(0.1, 0.9));
  vtkPolyData* const outlines = outputs[OutlinePort];
  WriteBoundary(
    input, surface.Kept, surface.Boundary, MarkBoundary(BoundaryType::Exterior, {}, surface.Boundary), outlines);
  if (!this->UseCuts)
  {
    RemoveCuts(outlines);
  }
  const auto loops =
    surface.Boundary.Boundary.RenumberedBy([&](PointId point) { return surface.Kept[std::size_t(point)]; });
  WriteLedger(points, surface.Kept, CoveredColumns(points.Column, loops, 1), outlines);
  vtkPolyData* const mesh = outputs[MeshPort];
  RemoveCuts(mesh); // The cuts of the outlines replace these.
  mesh->GetFieldData()->PassData(outlines->GetFieldData());
  if (surface.Kept.empty())
  {
    this->Warn(NothingLeft(input, this->MinimumPatchSize));
  }
  else
  {
    vtkFieldData* const figures = mesh->GetFieldData();
    AddValue<vtkDoubleArray>(figures, FieldArray::BoundaryDeviation, surface.BoundaryDeviation);
    AddValue<vtkDoubleArray>(figures, FieldArray::OutlineDeviation, surface.OutlineDeviation);
    AddValue<vtkDoubleArray>(figures, FieldArray::OutlineHeightDeviation, surface.OutlineHeightDeviation);
    AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfOutsidePoints, vtkIdType(surface.NumberOutside));
    WriteMesh(outlines, points.Lattice, surface.Mesh, mesh);
    const SharedRows rows{ options.Seams.Lower, options.Seams.Upper };
    WriteLedger(
      points, surface.Kept, CoveredColumns(surface.Mesh.Points.Plane, surface.Mesh.Points.Boundary, 1, rows), mesh);
    if (this->GetCloseFaults())
    {
      const Reduction& vertices = surface.Mesh.Points;
      CloseMesh(vertices.Plane, points.Lattice, vertices.Boundary, mesh, monitor.Step(0.95, 1.0));
    }
    if (HasSeams(options.Seams))
    {
      WriteSeams(outlines, points.Lattice, surface, options.Seams, onLowerSeam, mesh);
    }
  }
  WriteChosen(surface.Parameters, mesh->GetFieldData());
  if (limit.Noise)
  {
    WriteHeightNoise(*limit.Noise, mesh->GetFieldData());
  }
}
