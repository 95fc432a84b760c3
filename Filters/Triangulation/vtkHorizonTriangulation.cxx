// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTriangulation.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Filters/Marshalling/CrackData.h"
#include "Filters/Marshalling/HorizonCells.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/LedgerOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

BoundedHorizon MakeHull(const LatticePoints& points)
{
  BoundedHorizon horizon;
  horizon.SubVoxelsPerColumn = points.Lattice.SubVoxelsPerColumn();
  horizon.Plane = ToSubVoxels(points);
  horizon.Patch.assign(horizon.Plane.size(), 0);
  horizon.Boundary = FindConvexHull(horizon.Plane);
  return horizon;
}

/// The surface is to the right of loops, so triangles are reversed.
Loops MakeLoops(const RawVector<PointId>& triangles)
{
  Loops loops;
  for (auto corner = triangles.begin(); corner != triangles.end(); corner += 3)
  {
    loops.Append(corner[0]);
    loops.Append(corner[2]);
    loops.Append(corner[1]);
    loops.Close();
  }
  return loops;
}

/// Voxels are drawn as squares at the height of the first point.
void WriteWalk(const std::vector<TracedCell>& walk, std::int32_t subVoxelsPerColumn, const Lattice& lattice,
  double height, vtkPolyData* output)
{
  const double perSubVoxel = 1.0 / subVoxelsPerColumn; // exact
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> squares;
  for (const TracedCell& cell : walk)
  {
    const double x0 = cell.Least.X * perSubVoxel;
    const double y0 = cell.Least.Y * perSubVoxel;
    const double x1 = cell.Greatest.X * perSubVoxel;
    const double y1 = cell.Greatest.Y * perSubVoxel;
    std::array<vtkIdType, 4> ids;
    const std::array<Eigen::Vector3d, 4> corners = { Eigen::Vector3d(x0, y0, height), { x1, y0, height },
      { x1, y1, height }, { x0, y1, height } };
    for (std::size_t n = 0; n < 4; ++n)
    {
      ids[n] = points->InsertNextPoint(lattice.ToWorld(corners[n]).data());
    }
    squares->InsertNextCell(4, ids.data());
  }
  output->SetPoints(points);
  output->SetPolys(squares);
  AddArray<vtkIntArray>(
    output->GetCellData(), CellArray::Dilatation, walk, [](const TracedCell& cell) { return cell.Dilatation; });
}
}

vtkStandardNewMacro(vtkHorizonTriangulation);

//------------------------------------------------------------------------------
vtkHorizonTriangulation::vtkHorizonTriangulation()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHorizonTriangulation::ProcessHorizon(vtkPolyData* given, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadPoints(given, outputs, KeptHeights::None);
  vtkPolyData* const input = points.Horizon;
  const Lattice& lattice = points.Lattice;
  BoundedHorizon horizon = this->ConvexHull ? MakeHull(points) : ReadPatchesAndBoundary(points);
  monitor.Progress(0.1);
  CheckAtLeast("maximum number of triangles", this->MaximumNumberOfTriangles, 0, " (all)");
  TriangulationOptions options;
  options.Strategy = static_cast<SeismicHorizons::SearchStrategy>(this->SearchStrategy);
  options.MostTriangles = std::size_t(this->MaximumNumberOfTriangles);
  Triangulation mesh = Triangulate(horizon, options, monitor.Step(0.1, 0.8));
  if (this->ConvexHull && this->MaximumNumberOfTriangles == 0)
  {
    RemoveOutsideTriangles(
      horizon, mesh, { this->MaximumBoundaryAngle, this->MaximumBoundaryEdgeLength }, monitor.Step(0.8, 0.85));
  }
  monitor.Progress(0.9);

  vtkPolyData* const output = outputs.front();
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  ActivateHeight(output);
  output->SetLines(MakePolylines(horizon.Boundary));
  if (this->ConvexHull || this->MaximumNumberOfTriangles > 0)
  {
    WriteLedger(points, KeptPoints::All(points.Column.size()),
      CoveredColumns(horizon.Plane, MakeLoops(mesh.Triangles), horizon.SubVoxelsPerColumn), output);
  }
  else if (!input->GetFieldData()->HasArray(FieldArray::LedgerColumns))
  {
    WriteLedger(points, KeptPoints::All(points.Column.size()),
      CoveredColumns(horizon.Plane, horizon.Boundary, horizon.SubVoxelsPerColumn), output);
  }
  const double smallestAngle = WriteTriangles(horizon.Plane, lattice, std::move(mesh.Triangles), output);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  AddValue<vtkIdTypeArray>(figures, FieldArray::BoundaryEdgeCount, vtkIdType(mesh.BoundaryEdges));
  AddValue<vtkIdTypeArray>(figures, FieldArray::NonDelaunayEdgeCount, vtkIdType(mesh.NonDelaunayEdges));
  AddValue<vtkDoubleArray>(figures, FieldArray::SmallestAngle, smallestAngle);
  if (this->CloseFaults && !this->ConvexHull && this->MaximumNumberOfTriangles == 0)
  {
    CloseMesh(horizon.Plane, lattice, horizon.Boundary, output, monitor.Step(0.95, 1.0));
  }
  WriteWalk(mesh.Walk, horizon.SubVoxelsPerColumn, lattice, points.HeightAt(0), outputs[1]);
}
