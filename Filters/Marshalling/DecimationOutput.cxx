// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DecimationOutput.h"

#include "Common/DataModel.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"
#include "Common/VTK/DataArrays.h"
#include "HorizonCells.h"
#include "HorizonPoints.h"
#include "ReducedHorizon.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void WriteMesh(Decimation& decimation, const Lattice& grid, vtkPolyData* output)
{
  output->SetVerts(nullptr);
  const double smallestAngle = WriteTriangles(decimation.Points.Plane, grid, std::move(decimation.Triangles), output);
  AddTriangleArray<vtkDoubleArray>(CellArray::Error, decimation.Errors, output);
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestError, decimation.LargestError);
  AddValue<vtkDoubleArray>(figures, FieldArray::MeanError, decimation.MeanError);
  AddValue<vtkDoubleArray>(figures, FieldArray::LargestLoopError,
    std::max(decimation.LargestLoopError, FirstValue(figures, FieldArray::OutlineHeightDeviation)));
  AddValue<vtkIdTypeArray>(figures, FieldArray::TriangleCount, output->GetNumberOfPolys());
  AddValue<vtkDoubleArray>(figures, FieldArray::SmallestAngle, smallestAngle);
  AddValue<vtkIdTypeArray>(figures, FieldArray::SliverCount, vtkIdType(decimation.NumberOfSlivers));
}
}

//----------------------------------------------------------------------------------------------------------------------
double ErrorInLatticeUnits(
  double error, ErrorUnit unit, PlanePoints columns, const std::vector<double>& height, const Lattice& grid)
{
  CheckAtLeast("maximum error", error, 0.0, "");
  if (unit == ErrorUnit::World)
  {
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    return error / std::abs((grid.ToWorld(up) - grid.ToWorld(Eigen::Vector3d::Zero())).z());
  }
  if (unit == ErrorUnit::Diagonal)
  {
    const PlaneBox box(columns);
    const auto ends = std::minmax_element(height.begin(), height.end());
    const Eigen::Vector3d diagonal(
      double(box.Greatest.X) - box.Least.X, double(box.Greatest.Y) - box.Least.Y, *ends.second - *ends.first);
    return error * diagonal.norm();
  }
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDecimation(vtkPolyData* input, const Lattice& grid, Decimation& decimation, vtkPolyData* output)
{
  output->SetPoints(MakePoints(input, grid, decimation.Points));
  WriteReduction(input, decimation.Points, output);
  ActivateHeight(output);
  WriteMesh(decimation, grid, output);
}
}
