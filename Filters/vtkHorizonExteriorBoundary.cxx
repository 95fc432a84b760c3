// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonExteriorBoundary.h"

#include "DataModel.h"
#include "ExteriorBoundary.h"
#include "HorizonData.h"

#include "vtkCellArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
void AddPatches(const std::vector<std::int32_t>& patches, vtkPolyData* output)
{
  vtkNew<vtkIntArray> array;
  array->SetName(SeismicHorizons::PointArray::PatchId);
  array->SetNumberOfValues(vtkIdType(patches.size()));
  std::copy(patches.begin(), patches.end(), array->Begin());
  output->GetPointData()->AddArray(array);
}

void AddBoundary(const SeismicHorizons::Loops& loops, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(SeismicHorizons::PointArray::Boundary);
  array->SetNumberOfValues(output->GetNumberOfPoints());
  array->FillValue(static_cast<unsigned char>(SeismicHorizons::BoundaryKind::Inside));
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    std::for_each(loops.begin(loop), loops.end(loop),
      [&array](SeismicHorizons::PointId point)
      { array->SetValue(point, static_cast<unsigned char>(SeismicHorizons::BoundaryKind::Exterior)); });
  }
  output->GetPointData()->AddArray(array);
}
}

vtkStandardNewMacro(vtkHorizonExteriorBoundary);

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::ProcessHorizon(
  vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor)
{
  const std::vector<SeismicHorizons::PlanePoint> columns =
    SeismicHorizons::ToColumns(SeismicHorizons::ReadPoints(input));
  monitor.Progress(0.3);
  const SeismicHorizons::ExteriorBoundary found =
    SeismicHorizons::FindExteriorBoundary(columns, {}, monitor.Step(0.3, 0.9));
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetVerts(SeismicHorizons::MakeVertices(input->GetNumberOfPoints()));
  output->SetLines(SeismicHorizons::MakePolylines(found.Boundary));
  AddPatches(found.Patch, output);
  AddBoundary(found.Boundary, output);
}
