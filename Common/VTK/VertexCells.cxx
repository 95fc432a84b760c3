// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexCells.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
template <typename Array>
void SetVertices(vtkIdType numberOfPoints, vtkCellArray* vertices)
{
  using Number = typename Array::ValueType;
  vtkNew<Array> offsets;
  vtkNew<Array> points;
  offsets->SetNumberOfValues(numberOfPoints + 1);
  points->SetNumberOfValues(numberOfPoints);
  std::iota(offsets->Begin(), offsets->End(), Number(0));
  std::iota(points->Begin(), points->End(), Number(0));
  vertices->SetData(offsets, points);
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType numberOfPoints)
{
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  // The last offset is the number of points.
  if (numberOfPoints <= std::numeric_limits<vtkTypeInt32>::max())
  {
    SetVertices<vtkTypeInt32Array>(numberOfPoints, vertices);
  }
  else
  {
    SetVertices<vtkTypeInt64Array>(numberOfPoints, vertices);
  }
  return vertices;
}
}
