// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurface.h"

#include "Boundary/BoundaryMarks.h"
#include "Common/DataModel.h"
#include "Common/Parameters.h"
#include "Common/VTK/DataArrays.h"
#include "Marshalling/BoundaryOutput.h"
#include "Marshalling/DecimationOutput.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/HorizonPoints.h"
#include "Surface/Surface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <optional>
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
void vtkHorizonSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto tell = [](bool isOn) { return isOn ? "on" : "off"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Target: " << (this->Target == LargestError ? "LargestError" : "NumberOfTriangles") << "\n";
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << "\n";
  os << indent << "AutomaticRadius: " << tell(this->AutomaticRadius) << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "GrowthStrategy: " << (this->GrowthStrategy == Distance ? "Distance" : "Clockwise") << "\n";
  os << indent << "HoleBoundaries: " << tell(this->HoleBoundaries) << "\n";
  os << indent << "AutomaticSmallestHoleSize: " << tell(this->AutomaticSmallestHoleSize) << "\n";
  os << indent << "SmallestHoleSize: " << this->SmallestHoleSize << "\n";
  os << indent << "MinimumPatchSize: " << this->MinimumPatchSize << "\n";
  os << indent << "AutomaticOutlineTolerance: " << tell(this->AutomaticOutlineTolerance) << "\n";
  os << indent << "OutlineTolerance: " << this->OutlineTolerance << "\n";
  os << indent << "AutomaticDistanceThreshold: " << tell(this->AutomaticDistanceThreshold) << "\n";
  os << indent << "DistanceThreshold: " << this->DistanceThreshold << "\n";
  os << indent << "FitHeights: " << tell(this->GetFitHeights()) << "\n";
}

//------------------------------------------------------------------------------
SurfaceOptions vtkHorizonSurface::MakeOptions(const LatticePoints& points) const
{
  SurfaceOptions options;
  static_cast<DecimationQuality&>(options) = this->MakeQuality();
  if (this->Target == LargestError)
  {
    options.MaximumError = this->FindMaximumError(points.Plane, points.Height, points.Grid);
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
  const vtkSmartPointer<vtkPolyData> input = WithoutHiddenPoints(horizon);
  LatticePoints points = ReadPoints(input);
  const SurfaceOptions options = this->MakeOptions(points);
  const std::int32_t size = points.Grid.SubVoxelsPerColumn();
  std::vector<PlanePoint> columns = ToColumns(std::move(points.Plane), points.Grid, ColumnTolerance::None);
  monitor.Progress(0.1);
  Surface surface =
    MakeSurface({ std::move(columns), {}, std::move(points.Height), size }, options, monitor.Step(0.1, 0.9));
  vtkPolyData* const outlines = outputs[OutlinePort];
  WriteBoundary(
    input, surface.Kept, surface.Boundary, MarkBoundary(BoundaryType::Exterior, {}, surface.Boundary), outlines);
  vtkPolyData* const mesh = outputs[MeshPort];
  mesh->GetFieldData()->PassData(outlines->GetFieldData());
  if (surface.Kept.empty())
  {
    vtkWarningMacro(<< NothingLeft(input, this->MinimumPatchSize));
  }
  else
  {
    vtkFieldData* const figures = mesh->GetFieldData();
    AddValue<vtkDoubleArray>(figures, FieldArray::BoundaryDeviation, surface.BoundaryDeviation);
    AddValue<vtkDoubleArray>(figures, FieldArray::OutlineDeviation, surface.OutlineDeviation);
    WriteDecimation(outlines, points.Grid, surface.Mesh, mesh);
  }
  WriteChosen(surface.Parameters, mesh->GetFieldData());
}
