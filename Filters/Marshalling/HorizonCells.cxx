// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCells.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
template <typename Array>
vtkSmartPointer<vtkCellArray> MakeCells(Array* offsets, Array* points)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

template <typename Array>
vtkSmartPointer<vtkCellArray> MakeTrianglesAs(const RawVector<PointId>& triangles)
{
  using Value = typename Array::ValueType;
  vtkNew<Array> offsets;
  vtkNew<Array> ids;
  const vtkIdType size = vtkIdType(triangles.size() / 3);
  SetNumberOfTuples(offsets, size + 1);
  SetNumberOfTuples(ids, 3 * size);
  offsets->SetValue(size, Value(3 * size));
  Value* const begins = offsets->GetPointer(0);
  Value* const corners = ids->GetPointer(0);
  ParallelFor(size, Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType triangle = first; triangle < last; ++triangle)
      {
        begins[triangle] = Value(3 * triangle);
      }
      std::copy(triangles.data() + 3 * first, triangles.data() + 3 * last, corners + 3 * first);
    });
  return MakeCells<Array>(offsets, ids);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops)
{
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> ids;
  offsets->InsertNextValue(0);
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    std::for_each(loops.begin(loop), loops.end(loop), [&ids](PointId point) { ids->InsertNextValue(point); });
    ids->InsertNextValue(*loops.begin(loop));
    offsets->InsertNextValue(std::int32_t(ids->GetNumberOfValues()));
  }
  return MakeCells<vtkTypeInt32Array>(offsets, ids);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles)
{
  assert(triangles.size() % 3 == 0);
  return triangles.size() <= std::size_t(std::numeric_limits<vtkTypeInt32>::max())
    ? MakeTrianglesAs<vtkTypeInt32Array>(triangles)
    : MakeTrianglesAs<vtkTypeInt64Array>(triangles);
}

//----------------------------------------------------------------------------------------------------------------------
double WriteTriangles(
  const std::vector<PlanePoint>& plane, const Lattice& lattice, RawVector<PointId> triangles, vtkPolyData* mesh)
{
  const TriangleQuality quality = MeasureQuality(plane, triangles);
  FaceUp(lattice, triangles);
  mesh->SetPolys(MakeTriangles(triangles));
  triangles = RawVector<PointId>(); // This frees memory for the arrays, which need as much.
  AddTriangleArray<vtkFloatArray>(CellArray::Compactness, quality.Compactness, mesh);
  AddTriangleArray<vtkFloatArray>(CellArray::Quality, quality.Shape, mesh);
  return quality.SmallestAngle;
}
}
