// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonDataSet.h"

#include "Common/DataModel.h"
#include "Common/Parallel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/VertexCells.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 1 << 14; // points that a thread makes at a time

vtkSmartPointer<vtkPoints> MakePoints(const HorizonVoxels& voxels, const HorizonPlacement& placement)
{
  const LatticeMatrix& toWorld = placement.ToWorld;
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(voxels.I.size()));
  double* const world = coordinates->GetPointer(0);
  ParallelFor(static_cast<std::int64_t>(voxels.I.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto voxel = static_cast<std::size_t>(first); voxel < static_cast<std::size_t>(last); ++voxel)
      {
        const double i = voxels.I[voxel];
        const double j = voxels.J[voxel];
        world[3 * voxel] = toWorld[0] * i + toWorld[1] * j + toWorld[3];
        world[3 * voxel + 1] = toWorld[4] * i + toWorld[5] * j + toWorld[7];
        world[3 * voxel + 2] = placement.Elevation(voxels, voxel);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}
}

//----------------------------------------------------------------------------------------------------------------------
void AddHorizonFields(vtkFieldData* data, const HorizonPlacement& placement, std::int64_t droppedDuplicates)
{
  AddTuple<vtkIntArray>(data, FieldArray::LatticeDimensions, placement.Size);
  AddTuple<vtkDoubleArray>(data, FieldArray::LatticeToWorld, placement.ToWorld);
  AddValue<vtkIntArray>(data, FieldArray::VerticalDirection, static_cast<int>(placement.Direction));
  AddValue<vtkIdTypeArray>(data, FieldArray::DroppedDuplicates, static_cast<vtkIdType>(droppedDuplicates));
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeHorizonPoints(HorizonVoxels voxels, const HorizonPlacement& placement)
{
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  horizon->SetPoints(MakePoints(voxels, placement));
  voxels.I = HeapArray<int>();
  voxels.J = HeapArray<int>();

  const vtkIdType numberOfPoints = horizon->GetNumberOfPoints();
  vtkPointData* const data = horizon->GetPointData();
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, numberOfPoints, voxels.SurfaceId);
  MoveToArray<vtkIntArray>(data, PointArray::VerticalIndex, voxels.K);
  MoveToArray<vtkDoubleArray>(data, PointArray::Thickness, voxels.Thickness);
  MoveToArray<vtkDoubleArray>(data, PointArray::Amplitude, voxels.Amplitude);
  MoveToArray<vtkDoubleArray>(data, PointArray::RealZ, voxels.RealZ);
  AddConstant<vtkIdTypeArray>(data, PointArray::PointCount, numberOfPoints, 1);
  data->SetActiveScalars(PointArray::VerticalIndex); // what ParaView colours by at first
  horizon->SetVerts(MakeVertices(numberOfPoints));

  AddHorizonFields(horizon->GetFieldData(), placement, voxels.DroppedDuplicates);
  return horizon;
}
}
