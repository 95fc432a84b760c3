// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCellSimplification.h"

#include "Common/Base/Monitor.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/ReducedHorizon.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
using namespace SeismicHorizons;

/// A single line along the edges; for a box it retraces some of the 12 edges and takes 15 steps.
void AddOutline(const SimplificationCell& cell, bool isCube, const Lattice& lattice, vtkPolyData* output)
{
  const vtkIdType first = output->GetNumberOfPoints();
  for (int corner = 0; corner < (isCube ? 8 : 4); ++corner)
  {
    // Corners run around the bottom, then around the top.
    const bool right = corner % 4 == 1 || corner % 4 == 2;
    const bool back = corner % 4 >= 2;
    const Eigen::Vector3d steps(right ? 1.0 : 0.0, back ? 1.0 : 0.0, corner >= 4 ? 1.0 : 0.0);
    const Eigen::Vector3d low(cell.Low.X, cell.Low.Y, cell.Low.Z);
    output->GetPoints()->InsertNextPoint(lattice.ToWorld(low + cell.Size * steps).data());
  }
  const vtkIdType square[5] = { 0, 1, 2, 3, 0 };
  const vtkIdType rest[11] = { 4, 5, 1, 5, 6, 2, 6, 7, 3, 7, 4 };
  vtkCellArray* const lines = output->GetLines();
  lines->InsertNextCell(isCube ? 16 : 5);
  for (const vtkIdType corner : square)
  {
    lines->InsertCellPoint(first + corner);
  }
  for (int n = 0; isCube && n < 11; ++n)
  {
    lines->InsertCellPoint(first + rest[n]);
  }
}

void WriteCells(const Reduction& reduction, bool areCubes, const Lattice& lattice, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  output->SetPoints(points);
  output->SetLines(vtkNew<vtkCellArray>());
  vtkSmartPointer<vtkIntArray> origins = NewOriginArray(vtkIdType(reduction.Cells.size()));
  for (std::size_t n = 0; n < reduction.Cells.size(); ++n)
  {
    AddOutline(reduction.Cells[n], areCubes, lattice, output);
    SetOrigin(origins, vtkIdType(n), reduction.Cells[n].Origin);
  }
  vtkCellData* const data = output->GetCellData();
  data->AddArray(origins);
  AddArray<vtkDoubleArray>(
    data, CellArray::CellSize, reduction.Cells, [](const SimplificationCell& cell) { return cell.Size; });
  AddArray<vtkIntArray>(
    data, PointArray::PatchId, reduction.Cells, [](const SimplificationCell& cell) { return cell.Patch; });
  AddArray<vtkIdTypeArray>(
    data, PointArray::PointCount, reduction.Cells, [](const SimplificationCell& cell) { return cell.Points; });
  if (!reduction.Flatness.empty())
  {
    AddArray<vtkDoubleArray>(
      data, PointArray::Flatness, reduction.Cells, [](const SimplificationCell& cell) { return cell.Flatness; });
  }
  data->SetActiveScalars(CellArray::CellSize);
}
}

//------------------------------------------------------------------------------
void vtkHorizonCellSimplification::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  CheckAtLeast("maximum number of points", this->MaximumNumberOfPoints, 0, ", which stands for CellSize");
  vtkPolyData* const output = outputs.front();
  LatticePoints points = ReadPoints(horizon, outputs);
  const vtkSmartPointer<vtkPolyData> input = points.Horizon;
  const Lattice lattice = points.Lattice;
  monitor.Progress(0.1);
  // The input horizon is freed before the output is made.
  Reduction reduction =
    this->Simplify(ReadBoundedHorizon(std::move(points)), output->GetFieldData(), monitor.Step(0.2, 0.8));
  if (this->ShowCells)
  {
    WriteCells(reduction, this->HasCubes(), lattice, output);
  }
  else
  {
    output->SetPoints(MakePoints(input, lattice, reduction));
    reduction.Plane = std::vector<PlanePoint>(); // This frees memory for the arrays.
    reduction.Height = std::vector<double>();
    WriteReduction(input, reduction, output);
    ActivateHeight(output);
  }
}
