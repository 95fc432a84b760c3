// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonMatrix.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonData.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
vtkDataArray* FindArray(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = horizon->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() != 1)
  {
    throw InputError("point array " + std::string(name) + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected 1");
  }
  return array;
}

HeapArray<double> CopyNumbers(vtkDataArray* array)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->DeepCopy(array);
  HeapArray<double> copy;
  copy.append(numbers->GetPointer(0), numbers->GetPointer(0) + numbers->GetNumberOfValues());
  return copy;
}

HeapArray<double> ReadNumbers(vtkPolyData* horizon, const char* name, double otherwise)
{
  vtkDataArray* const array = FindArray(horizon, name);
  if (array)
  {
    return CopyNumbers(array);
  }
  HeapArray<double> numbers;
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    numbers.push_back(otherwise);
  }
  return numbers;
}

int ToInteger(double number, const char* name, std::size_t point)
{
  constexpr double least = std::numeric_limits<int>::min();
  constexpr double greatest = std::numeric_limits<int>::max();
  if (!(number >= least && number <= greatest) || number != std::floor(number))
  {
    throw InputError(std::string(name) + ' ' + std::to_string(number) + " at point " + std::to_string(point) +
      ", expected an integer of 32 bits");
  }
  return int(number);
}

/// Without an array the nearest indices are used.
HeapArray<int> ReadIndices(vtkPolyData* horizon, const std::vector<double>& heights)
{
  vtkDataArray* const array = FindArray(horizon, PointArray::VerticalIndex);
  HeapArray<int> indices;
  for (std::size_t point = 0; point < heights.size(); ++point)
  {
    const double number = array ? array->GetComponent(vtkIdType(point), 0) : std::round(heights[point]);
    indices.push_back(ToInteger(number, PointArray::VerticalIndex, point));
  }
  return indices;
}

/// Without an array the reader's conversion of real z is inverted.
HeapArray<double> ReadRealZ(vtkPolyData* horizon)
{
  if (vtkDataArray* const array = FindArray(horizon, PointArray::RealZ))
  {
    return CopyNumbers(array);
  }
  const bool isUp = FirstValue(horizon->GetFieldData(), FieldArray::VerticalDirection) > 0.0;
  HeapArray<double> realZ;
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    const double z = horizon->GetPoint(point)[2];
    realZ.push_back(isUp ? z : 0.0 - z); // Avoids -0.
  }
  return realZ;
}
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize ReadMatrixSize(vtkPolyData* horizon)
{
  ReadLattice(horizon); // Refuses horizons without a valid lattice.
  return ReadLatticeDimensions(horizon);
}

//----------------------------------------------------------------------------------------------------------------------
std::array<double, 2> ReadVerticalScale(vtkPolyData* horizon)
{
  const Eigen::Matrix4d map = ReadLatticeMap(horizon);
  return { map(2, 3), map(2, 2) };
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<int> ReadSurfaceId(vtkPolyData* horizon)
{
  vtkDataArray* const ids = FindArray(horizon, PointArray::SurfaceId);
  if (!ids || ids->GetNumberOfTuples() == 0)
  {
    return {};
  }
  double range[2];
  ids->GetRange(range);
  if (range[0] != range[1])
  {
    throw InputError("points with surface IDs from " + std::to_string(std::int64_t(range[0])) + " to " +
      std::to_string(std::int64_t(range[1])) + ", expected one ID in a horizon");
  }
  return ToInteger(range[0], PointArray::SurfaceId, 0);
}

//----------------------------------------------------------------------------------------------------------------------
LatticeHorizon ReadVoxels(vtkPolyData* horizon, int surfaceId)
{
  const LatticePoints points = ReadColumns(horizon, {});
  LatticeHorizon voxels;
  voxels.SurfaceId = surfaceId;
  for (const PlanePoint& column : points.Column)
  {
    voxels.Column.push_back({ column.X, column.Y });
  }
  voxels.K = ReadIndices(horizon, points.Height);
  voxels.Thickness = ReadNumbers(horizon, PointArray::Thickness, 1.0);
  voxels.Amplitude = ReadNumbers(horizon, PointArray::Amplitude, 0.0);
  voxels.RealZ = ReadRealZ(horizon);
  return voxels;
}
}
