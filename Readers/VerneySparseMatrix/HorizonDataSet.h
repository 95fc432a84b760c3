// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns the voxels of a horizon into the point surface that the stages work on (Documentation/DataModel.md), and holds
// what its datasets of any kind have in common.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/DataModel.h"
#include "SparseMatrixParser.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
/// The affine map from the lattice to the world, row by row.
using LatticeMatrix = std::array<double, 16>;

/// Moves values into an array of VTK and frees what held them.
template <typename Array, typename Value>
void TakeArray(vtkFieldData* data, const char* name, std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  std::vector<Value>().swap(values);
  data->AddArray(array);
}

/// Adds an array of a single tuple.
template <typename Array, typename Tuple>
void AddTuple(vtkFieldData* data, const char* name, const Tuple& tuple)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(tuple.size()));
  array->SetNumberOfTuples(1);
  std::copy(tuple.begin(), tuple.end(), array->GetPointer(0));
  data->AddArray(array);
}

template <typename Array, typename Value>
void AddConstant(vtkFieldData* data, const char* name, vtkIdType numberOfValues, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(numberOfValues);
  array->FillValue(value);
  data->AddArray(array);
}

inline vtkSmartPointer<vtkPoints> MakePoints(const HorizonVoxels& voxels, const LatticeMatrix& toWorld, bool useRealZ)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(voxels.I.size()));
  double* world = coordinates->GetPointer(0);
  for (std::size_t voxel = 0; voxel < voxels.I.size(); ++voxel)
  {
    const double i = voxels.I[voxel];
    const double j = voxels.J[voxel];
    *world++ = toWorld[0] * i + toWorld[1] * j + toWorld[3];
    *world++ = toWorld[4] * i + toWorld[5] * j + toWorld[7];
    *world++ = useRealZ ? voxels.RealZ[voxel] : toWorld[10] * voxels.K[voxel] + toWorld[11];
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

/// One vertex cell for each of the points.
template <typename Array>
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType numberOfPoints)
{
  vtkNew<Array> offsets;
  vtkNew<Array> connectivity;
  offsets->SetNumberOfValues(numberOfPoints + 1);
  connectivity->SetNumberOfValues(numberOfPoints);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + numberOfPoints + 1, 0);
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + numberOfPoints, 0);
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(offsets, connectivity);
  return vertices;
}

/// What every dataset of a horizon says of it.
inline void AddHorizonFields(
  vtkFieldData* data, const SparseMatrixSize& size, const LatticeMatrix& toWorld, std::int64_t droppedDuplicates)
{
  AddTuple<vtkIntArray>(data, FieldArray::LatticeDimensions, size);
  AddTuple<vtkDoubleArray>(data, FieldArray::LatticeToWorld, toWorld);
  AddConstant<vtkIdTypeArray>(data, FieldArray::DroppedDuplicates, 1, static_cast<vtkIdType>(droppedDuplicates));
}

/// Makes the point surface of a horizon and uses the voxels up.
inline vtkSmartPointer<vtkPolyData> MakeHorizonPoints(
  HorizonVoxels voxels, const SparseMatrixSize& size, const LatticeMatrix& toWorld, bool useRealZ)
{
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  horizon->SetPoints(MakePoints(voxels, toWorld, useRealZ));
  std::vector<int>().swap(voxels.I);
  std::vector<int>().swap(voxels.J);

  const vtkIdType numberOfPoints = horizon->GetNumberOfPoints();
  vtkPointData* const pointData = horizon->GetPointData();
  AddConstant<vtkIntArray>(pointData, PointArray::SurfaceId, numberOfPoints, voxels.SurfaceId);
  TakeArray<vtkIntArray>(pointData, PointArray::VerticalIndex, voxels.K);
  TakeArray<vtkDoubleArray>(pointData, PointArray::Thickness, voxels.Thickness);
  TakeArray<vtkDoubleArray>(pointData, PointArray::Amplitude, voxels.Amplitude);
  TakeArray<vtkDoubleArray>(pointData, PointArray::RealZ, voxels.RealZ);
  AddConstant<vtkIdTypeArray>(pointData, PointArray::PointCount, numberOfPoints, vtkIdType(1));
  horizon->SetVerts(numberOfPoints < std::numeric_limits<vtkTypeInt32>::max()
      ? MakeVertices<vtkTypeInt32Array>(numberOfPoints)
      : MakeVertices<vtkTypeInt64Array>(numberOfPoints));

  AddHorizonFields(horizon->GetFieldData(), size, toWorld, voxels.DroppedDuplicates);
  return horizon;
}
}

#endif
