// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnPoints_h
#define SeismicHorizonsColumnPoints_h

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Types.h"
#include "Common/Survey/LatticeFrame.h"
#include "DataArrays.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
/// elevation(n) is world z. Points have double precision.
template <typename Elevation>
vtkSmartPointer<vtkPoints> MakeColumnPoints(PlanePoints columns, const LatticeMatrix& toWorld, Elevation&& elevation)
{
  auto coordinates = NewArray<vtkDoubleArray>("Points", static_cast<vtkIdType>(columns.size()), 3);
  double* const world = coordinates->GetPointer(0);
  ParallelFor(static_cast<std::int64_t>(columns.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = static_cast<std::size_t>(first); n < static_cast<std::size_t>(last); ++n)
      {
        world[3 * n] = toWorld[0] * columns[n].X + toWorld[1] * columns[n].Y + toWorld[3];
        world[3 * n + 1] = toWorld[4] * columns[n].X + toWorld[5] * columns[n].Y + toWorld[7];
        world[3 * n + 2] = elevation(n);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

inline vtkSmartPointer<vtkIntArray> NewColumnArray()
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(PointArray::Column);
  array->SetNumberOfComponents(2);
  array->SetComponentName(0, "I");
  array->SetComponentName(1, "J");
  return array;
}

inline vtkSmartPointer<vtkIntArray> MoveToColumnArray(HeapArray<PlanePoint>& columns)
{
  auto array = NewColumnArray();
  const auto size = static_cast<vtkIdType>(columns.size());
  array->SetArray(reinterpret_cast<int*>(columns.Release()), 2 * size, 0, vtkIntArray::VTK_DATA_ARRAY_FREE);
  return array;
}
}

#endif
