// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonDataSet.h"

#include "ColumnPoints.h"
#include "Common/DataModel.h"
#include "DataArrays.h"
#include "VertexCells.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace SeismicHorizons
{
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
  horizon->SetPoints(MakeColumnPoints({ voxels.Column.data(), voxels.Column.size() }, placement.ToWorld,
    [&](std::size_t voxel) { return placement.Elevation(voxels, voxel); }));
  const auto columns = MoveToColumnArray(voxels.Column);

  const vtkIdType numberOfPoints = horizon->GetNumberOfPoints();
  vtkPointData* const data = horizon->GetPointData();
  data->AddArray(columns);
  AddConstant<vtkIntArray>(data, PointArray::SurfaceId, numberOfPoints, voxels.SurfaceId);
  MoveToArray<vtkIntArray>(data, PointArray::VerticalIndex, voxels.K);
  MoveToArray<vtkDoubleArray>(data, PointArray::Thickness, voxels.Thickness);
  MoveToArray<vtkDoubleArray>(data, PointArray::Amplitude, voxels.Amplitude);
  MoveToArray<vtkDoubleArray>(data, PointArray::RealZ, voxels.RealZ);
  data->SetActiveScalars(PointArray::VerticalIndex); // what ParaView colours by at first
  horizon->SetVerts(MakeVertices(numberOfPoints));

  AddHorizonFields(horizon->GetFieldData(), placement, voxels.DroppedDuplicates);
  return horizon;
}
}
