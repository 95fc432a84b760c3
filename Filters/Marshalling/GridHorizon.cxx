// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridHorizon.h"

#include "Common/Base/Errors.h"
#include "Common/VTK/VersionDifferences.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace SeismicHorizons
{
namespace
{
/// Filters make no strips of horizons.
struct Cells
{
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Polygons;

  vtkCellArray* ForType(int type, vtkIdType cell) const
  {
    switch (type)
    {
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        return this->Vertices;
      case VTK_LINE:
      case VTK_POLY_LINE:
        return this->Lines;
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        return this->Polygons;
      default:
        throw InputError("cell " + std::to_string(cell) + " of an unstructured grid is a " + CellTypeName(type) +
          ", expected vertices, lines and polygons, as Extract Surface makes them");
    }
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToPolyData(vtkUnstructuredGrid* grid)
{
  const Cells cells;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkCellArray* const kind = cells.ForType(grid->GetCellType(cell), cell);
    grid->GetCellPoints(cell, points);
    kind->InsertNextCell(points);
  }
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  horizon->SetPoints(grid->GetPoints());
  horizon->SetVerts(cells.Vertices);
  horizon->SetLines(cells.Lines);
  horizon->SetPolys(cells.Polygons);
  horizon->GetPointData()->ShallowCopy(grid->GetPointData());
  horizon->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return horizon;
}
}
