// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeConversion.h"

#include "HorizonConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
VolumeGrid FromVTK(vtkUnstructuredGrid* given)
{
  VolumeGrid grid;
  if (given->GetPoints())
  {
    grid.Places = FromVTK(given->GetPoints()->GetData());
  }
  if (given->GetNumberOfCells() > 0)
  {
    grid.Cells = FromVTK(given->GetCells());
    grid.Types = FromVTK(given->GetCellTypesArray());
  }
  grid.PointData = FromVTK(given->GetPointData());
  grid.CellData = FromVTK(given->GetCellData());
  grid.FieldData = FromVTK(given->GetFieldData());
  return grid;
}

//----------------------------------------------------------------------------------------------------------------------
void ToVTK(const VolumeGrid& grid, vtkUnstructuredGrid* output)
{
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetData(vtkDataArray::SafeDownCast(ToVTK(grid.Places)));
  output->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->SetData(
    vtkIdTypeArray::SafeDownCast(ToVTK(grid.Cells.Offsets)), vtkIdTypeArray::SafeDownCast(ToVTK(grid.Cells.Points)));
  output->SetCells(vtkUnsignedCharArray::SafeDownCast(ToVTK(grid.Types)), cells);
  ToVTK(grid.PointData, output->GetPointData());
  ToVTK(grid.CellData, output->GetCellData());
  ToVTK(grid.FieldData, output->GetFieldData());
}
}
