// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVerneySparseMatrixWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "SparseMatrixPrinter.h"
#include "Writers/HorizonSampling.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

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

SparseMatrixSize ReadMatrixSize(vtkPolyData* horizon)
{
  ReadLattice(horizon); // Refuses horizons without a valid lattice.
  return ReadLatticeDimensions(horizon);
}

/// Returns world z of vertical index 0, and its step per index.
std::array<double, 2> ReadVerticalScale(vtkPolyData* horizon)
{
  const Eigen::Matrix4d map = ReadLatticeMap(horizon);
  return { map(2, 3), map(2, 2) };
}

/// All points must have the same ID; without an array there is none.
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

/// vtkVerneySparseMatrixWriter documents the defaults of missing arrays. Throws InputError if points are not on
/// columns.
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

std::string NumberText(const SparseMatrixSize& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

int TakeFreeId(std::set<int>& ids)
{
  int id = 1;
  while (!ids.insert(id).second)
  {
    ++id;
  }
  return id;
}
}

vtkStandardNewMacro(vtkVerneySparseMatrixWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  SparseMatrix matrix;
  std::vector<std::optional<int>> given;
  std::set<int> ids;
  bool isUp = false;
  for (const NamedHorizon& horizon : horizons)
  {
    PrefixErrors(horizon.Name,
      [&]()
      {
        const SparseMatrixSize size = ReadMatrixSize(horizon.Data);
        CountColumns(size[0], size[1], horizon.Data->GetNumberOfPoints());
        matrix.Size = given.empty() ? size : matrix.Size;
        const std::array<double, 2> scale = ReadVerticalScale(horizon.Data);
        const std::array<double, 2> first = ReadVerticalScale(horizons.front().Data);
        if (scale != first)
        {
          std::ostringstream text;
          text << "vertical indices from " << scale[0] << " in steps of " << scale[1] << ", expected from " << first[0]
               << " in steps of " << first[1] << " as in " << horizons.front().Name
               << "; with VerticalStep, readers give all horizons the same";
          throw InputError(text.str());
        }
        if (size != matrix.Size)
        {
          throw InputError("a lattice of " + NumberText(size) + " cells, expected " + NumberText(matrix.Size) +
            " as in " + horizons.front().Name);
        }
        isUp = isUp || FirstValue(horizon.Data->GetFieldData(), FieldArray::VerticalDirection) > 0.0;
        given.push_back(ReadSurfaceId(horizon.Data));
        if (given.back())
        {
          ids.insert(*given.back());
        }
      });
  }
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    monitor.Progress(0.5 * static_cast<double>(n) / static_cast<double>(horizons.size()));
    const int id = given[n] ? *given[n] : TakeFreeId(ids);
    PrefixErrors(horizons[n].Name, [&]() { matrix.Horizons.push_back(ReadVoxels(horizons[n].Data, id)); });
  }
  if (isUp)
  {
    vtkWarningMacro("elevations, which the format cannot tell from depths: read them with VerticalDirection Up");
  }
  PrintSparseMatrix(matrix, stream, monitor.Step(0.5, 1.0));
}
