// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPoints.h"

#include "Common/DataModel.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
bool IsVisible(unsigned char ghost)
{
  return (ghost & (vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT)) == 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkIdType CountVisiblePoints(vtkPolyData* horizon)
{
  vtkUnsignedCharArray* const ghosts = horizon->GetPointGhostArray();
  return ghosts ? std::count_if(ghosts->Begin(), ghosts->End(), IsVisible) : horizon->GetNumberOfPoints();
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutHiddenPoints(vtkPolyData* horizon)
{
  const vtkIdType visible = CountVisiblePoints(horizon);
  if (visible == horizon->GetNumberOfPoints())
  {
    return horizon;
  }
  vtkUnsignedCharArray* const ghosts = horizon->GetPointGhostArray();
  vtkNew<vtkIdList> kept;
  kept->Allocate(visible);
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    if (IsVisible(ghosts->GetValue(point)))
    {
      kept->InsertNextId(point);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  CopyPoints(horizon, kept, result);
  result->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  result->GetFieldData()->PassData(horizon->GetFieldData());
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
void CopyPoints(vtkPolyData* input, vtkIdList* kept, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  input->GetPoints()->GetPoints(kept, points);
  output->SetPoints(points);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData(), kept->GetNumberOfIds());
  for (vtkIdType point = 0; point < kept->GetNumberOfIds(); ++point)
  {
    output->GetPointData()->CopyData(input->GetPointData(), kept->GetId(point), point);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ActivateHeight(vtkPolyData* horizon)
{
  if (horizon->GetPointData()->HasArray(PointArray::VerticalIndex))
  {
    horizon->GetPointData()->SetActiveScalars(PointArray::VerticalIndex);
  }
}
}
