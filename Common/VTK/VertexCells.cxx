// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexCells.h"

#include "Common/Parallel.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 65536; // cells that a thread takes at a time

template <typename Number>
bool Counts(const Number* numbers, vtkIdType size)
{
  std::atomic<bool> isSame(true);
  ParallelFor(size, Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      bool isSameHere = true;
      for (std::int64_t n = first; n < last; ++n)
      {
        isSameHere &= numbers[n] == Number(n);
      }
      isSame = isSame && isSameHere;
    });
  return isSame;
}

/// Whether an array holds the numbers from 0 on.
bool Counts(vtkDataArray* array)
{
  const vtkIdType size = array->GetNumberOfTuples();
  if (auto* const narrow = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(array))
  {
    return Counts(narrow->GetPointer(0), size);
  }
  if (auto* const wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(array))
  {
    return Counts(wide->GetPointer(0), size);
  }
  // From VTK 9.6 on, offsets may be a formula.
  vtkIdType same = 0;
  while (same < size && array->GetComponent(same, 0) == double(same))
  {
    ++same;
  }
  return same == size;
}

/// Fills an array with the numbers from 0 on.
template <typename Array>
void Count(vtkIdType size, Array* array)
{
  using Number = typename Array::ValueType;
  array->SetNumberOfValues(size);
  Number* const numbers = array->GetPointer(0);
  ParallelFor(size, Grain,
    [&](std::int64_t first, std::int64_t last) { std::iota(numbers + first, numbers + last, Number(first)); });
}

template <typename Array>
void SetVertices(vtkIdType numberOfPoints, vtkCellArray* vertices)
{
  vtkNew<Array> offsets;
  vtkNew<Array> points;
  Count(numberOfPoints + 1, offsets.Get());
  Count(numberOfPoints, points.Get());
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

//----------------------------------------------------------------------------------------------------------------------
bool HasAllVertices(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() != numberOfPoints || cells->GetNumberOfConnectivityIds() != numberOfPoints)
  {
    return false;
  }
  return Counts(cells->GetOffsetsArray()) && Counts(cells->GetConnectivityArray());
}
}
