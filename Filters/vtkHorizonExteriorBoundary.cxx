// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonExteriorBoundary.h"

#include "Boundary/BoundaryMarks.h"
#include "Boundary/ExteriorBoundary.h"
#include "Common/DataModel.h"
#include "Common/Parameters.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/VertexCells.h"
#include "Marshalling/HorizonCells.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/HorizonPoints.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace SeismicHorizons;

/// Copies the points that have a patch, with their arrays, and numbers them from 0.
void CopyPointsOfPatches(
  vtkPolyData* input, ExteriorBoundary& found, std::vector<BoundaryKind>& marks, vtkPolyData* output)
{
  vtkNew<vtkIdList> kept;
  std::vector<PointId> number(found.Patch.size(), NoPoint);
  for (std::size_t point = 0; point < number.size(); ++point)
  {
    if (found.Patch[point] != NoPatch)
    {
      const std::size_t last = std::size_t(kept->InsertNextId(vtkIdType(point)));
      number[point] = PointId(last);
      found.Patch[last] = found.Patch[point];
      marks[last] = marks[point];
    }
  }
  found.Patch.resize(std::size_t(kept->GetNumberOfIds()));
  marks.resize(found.Patch.size());
  found.Boundary = found.Boundary.Renumbered(number);
  CopyPoints(input, kept, output);
}
}

vtkStandardNewMacro(vtkHorizonExteriorBoundary);

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const types[] = { "Exterior", "Topological4", "Topological8" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BoundaryType: " << types[this->BoundaryType] << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "GrowthStrategy: " << (this->GrowthStrategy == Distance ? "Distance" : "Clockwise") << "\n";
  os << indent << "HoleBoundaries: " << (this->HoleBoundaries ? "on" : "off") << "\n";
  os << indent << "SmallestHoleSize: " << this->SmallestHoleSize << "\n";
  os << indent << "SmallestHoleArea: " << this->SmallestHoleArea << "\n";
  os << indent << "MinimumPatchSize: " << this->MinimumPatchSize << "\n";
}

//------------------------------------------------------------------------------
std::int64_t vtkHorizonExteriorBoundary::FindSmallestHoleSize(double columnArea) const
{
  CheckAtLeast("smallest hole size", this->SmallestHoleSize, 1, " column");
  CheckAtLeast("smallest hole area", this->SmallestHoleArea, 0.0, " square units of the world");
  // Areas are often whole multiples of the column's. The quotient may then come out a few roundings (1e-16 each) above
  // the whole number, which must not ask for one more column.
  constexpr double rounding = 1e-12;
  const double columns = std::ceil(this->SmallestHoleArea / columnArea * (1.0 - rounding));
  const double most = double(std::numeric_limits<std::int64_t>::max() / 2);
  return std::max(std::int64_t(this->SmallestHoleSize), columns > 0.0 ? std::int64_t(std::min(columns, most)) : 0);
}

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::ProcessHorizon(vtkPolyData* all, const Outputs& outputs, const Monitor& monitor)
{
  const vtkSmartPointer<vtkPolyData> input = WithoutHiddenPoints(all);
  vtkPolyData* const output = outputs.front();
  const LatticePoints points = ReadPoints(input);
  const std::vector<PlanePoint> columns = ToColumns(points);
  monitor.Progress(0.3);
  BoundaryOptions options;
  options.Radius = this->Radius;
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.HoleBoundaries = this->HoleBoundaries;
  options.SmallestHoleSize = this->FindSmallestHoleSize(points.Grid.ColumnArea());
  options.MinimumPatchSize = this->MinimumPatchSize;
  const auto type = static_cast<SeismicHorizons::BoundaryType>(this->BoundaryType);
  auto found = FindExteriorBoundary(columns, OptionsFor(type, options), monitor.Step(0.3, 0.9));
  if (found.NumberOfPatches == 0)
  {
    const std::string name = NameBySurfaceId(input);
    vtkWarningMacro(<< name << (name.empty() ? "" : ": ") << "no patch of at least " << this->MinimumPatchSize
                    << " points, so that nothing is left of the " << columns.size());
  }
  std::vector<BoundaryKind> marks = MarkBoundary(type, columns, found);
  if (std::find(found.Patch.begin(), found.Patch.end(), NoPatch) == found.Patch.end())
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
  }
  else
  {
    CopyPointsOfPatches(input, found, marks, output);
  }
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  output->SetLines(MakePolylines(found.Boundary));
  AddArray<vtkIntArray>(output->GetPointData(), PointArray::PatchId, found.Patch);
  AddArray<vtkUnsignedCharArray>(output->GetPointData(), PointArray::Boundary, marks,
    [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output->GetPointData()->SetActiveScalars(PointArray::PatchId);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfPatches, vtkIdType(found.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::NumberOfHoles, vtkIdType(found.Boundary.Size() - found.NumberOfPatches));
  AddValue<vtkIdTypeArray>(figures, FieldArray::DroppedSpeckPoints, vtkIdType(columns.size() - found.Patch.size()));
}
