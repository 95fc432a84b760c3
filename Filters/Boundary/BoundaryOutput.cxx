// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/CrackData.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonPoints.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void WriteBoundary(vtkPolyData* input, const KeptPoints& kept, const ExteriorBoundary& boundary,
  const std::vector<BoundaryKind>& marks, vtkPolyData* output)
{
  CopyPoints(input, kept, output);
  output->SetLines(MakePolylines(boundary.Boundary));
  AddArray<vtkIntArray>(output->GetPointData(), PointArray::PatchId, boundary.Patch);
  AddArray<vtkUnsignedCharArray>(output->GetPointData(), PointArray::Boundary, marks,
    [](BoundaryKind kind) { return static_cast<unsigned char>(kind); });
  output->GetPointData()->SetActiveScalars(PointArray::PatchId);
  vtkFieldData* const figures = output->GetFieldData();
  for (const char* const name : { FieldArray::BoundaryDeviation, FieldArray::OutlineDeviation,
         FieldArray::OutlineHeightDeviation, FieldArray::NumberOfOutsidePoints })
  {
    figures->RemoveArray(name); // These describe an earlier outline.
  }
  AddValue<vtkIdTypeArray>(figures, FieldArray::NumberOfPatches, vtkIdType(boundary.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::NumberOfHoles, vtkIdType(boundary.Boundary.Size() - boundary.NumberOfPatches));
  AddValue<vtkIdTypeArray>(
    figures, FieldArray::DroppedSmallPatchPoints, input->GetNumberOfPoints() - vtkIdType(kept.size()));
  WriteCracks(boundary.OpenCracks, output);
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveCuts(vtkPolyData* output)
{
  RemoveFaultedLinks(output->GetFieldData());
  for (const char* const name : { FieldArray::CrackOpenEnds, FieldArray::OldCrackOpenEnds, FieldArray::CrackLoops })
  {
    output->GetFieldData()->RemoveArray(name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string NothingLeft(vtkPolyData* input, int minimumPatchSize)
{
  return "none of the " + std::to_string(input->GetNumberOfPoints()) + " points is in a patch of MinimumPatchSize, " +
    std::to_string(minimumPatchSize) + " points, or more";
}
}
