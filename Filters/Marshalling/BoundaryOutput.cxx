// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryOutput.h"

#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/VertexCells.h"
#include "HorizonCells.h"
#include "HorizonPoints.h"

#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
void WritePoints(vtkPolyData* input, const std::vector<PointId>& kept, vtkPolyData* output)
{
  if (vtkIdType(kept.size()) == input->GetNumberOfPoints())
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
    return;
  }
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(vtkIdType(kept.size()));
  std::copy(kept.begin(), kept.end(), ids->begin());
  CopyPoints(input, ids, output);
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteBoundary(vtkPolyData* input, const std::vector<PointId>& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, vtkPolyData* output)
{
  WritePoints(input, kept, output);
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  output->SetLines(MakePolylines(boundary.Boundary));
  AddArray<vtkIntArray>(output->GetPointData(), PointArray::PatchId, boundary.Patch);
  AddArray<vtkUnsignedCharArray>(output->GetPointData(), PointArray::Boundary, marks,
    [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output->GetPointData()->SetActiveScalars(PointArray::PatchId);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfPatches, vtkIdType(boundary.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::NumberOfHoles, vtkIdType(boundary.Boundary.Size() - boundary.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::DroppedSpeckPoints, input->GetNumberOfPoints() - vtkIdType(kept.size()));
}

//----------------------------------------------------------------------------------------------------------------------
std::string NothingLeft(vtkPolyData* input, int minimumPatchSize)
{
  const std::string name = NameBySurfaceId(input);
  return name + (name.empty() ? "" : ": ") + "no patch of at least " + std::to_string(minimumPatchSize) +
    " points, so that nothing is left of the " + std::to_string(input->GetNumberOfPoints());
}
}
