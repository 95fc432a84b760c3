// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonMatrix.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Common/HorizonData.h"
#include "Writers/HorizonSampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// Null without numbers.
const DataArray* FindVoxelArray(const Horizon& horizon, const char* name)
{
  const DataArray* const array = horizon.PointData.Find(name);
  if (!array || array->IsText())
  {
    return nullptr;
  }
  if (array->Components() != 1)
  {
    throw InputError(
      "point array " + std::string(name) + " with " + std::to_string(array->Components()) + " components, expected 1");
  }
  return array;
}

HeapArray<double> CopyNumbers(const DataArray& array)
{
  HeapArray<double> copy;
  double* const values = copy.Extend(std::size_t(array.Size()));
  array.WithNumbers([&](const auto* numbers) { std::copy_n(numbers, array.Size(), values); });
  return copy;
}

HeapArray<double> ReadNumbers(const Horizon& horizon, const char* name, double otherwise)
{
  const DataArray* const array = FindVoxelArray(horizon, name);
  if (array)
  {
    return CopyNumbers(*array);
  }
  HeapArray<double> numbers;
  for (std::int64_t point = 0; point < horizon.NumberOfPoints(); ++point)
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
HeapArray<int> ReadIndices(const Horizon& horizon, const std::vector<double>& heights)
{
  const DataArray* const array = FindVoxelArray(horizon, PointArray::VerticalIndex);
  HeapArray<int> indices;
  for (std::size_t point = 0; point < heights.size(); ++point)
  {
    const double number = array ? array->At(std::int64_t(point)) : std::round(heights[point]);
    indices.push_back(ToInteger(number, PointArray::VerticalIndex, point));
  }
  return indices;
}

/// Without an array the reader's conversion of real z is inverted.
HeapArray<double> ReadRealZ(const Horizon& horizon)
{
  if (const DataArray* const array = FindVoxelArray(horizon, PointArray::RealZ))
  {
    return CopyNumbers(*array);
  }
  const bool isUp = FirstValue(horizon.FieldData, FieldArray::VerticalDirection) > 0.0;
  HeapArray<double> realZ;
  for (std::int64_t point = 0; point < horizon.NumberOfPoints(); ++point)
  {
    const double z = horizon.Places.At(point, 2);
    realZ.push_back(isUp ? z : 0.0 - z); // Avoids -0.
  }
  return realZ;
}

SparseMatrixSize ReadMatrixSize(const Horizon& horizon)
{
  ReadLattice(horizon); // Refuses horizons without a valid lattice.
  return ReadLatticeDimensions(horizon);
}

/// Returns world z of vertical index 0, and its step per index.
std::array<double, 2> ReadVerticalScale(const Horizon& horizon)
{
  const Eigen::Matrix4d map = ReadLatticeMap(horizon);
  return { map(2, 3), map(2, 2) };
}

/// All points must have the same ID; without an array there is none.
std::optional<int> ReadSurfaceId(const Horizon& horizon)
{
  const DataArray* const ids = FindVoxelArray(horizon, PointArray::SurfaceId);
  if (!ids || ids->Tuples() == 0)
  {
    return {};
  }
  double least = std::nan("");
  double greatest = least;
  for (std::int64_t point = 0; point < ids->Tuples(); ++point)
  {
    least = std::fmin(least, ids->At(point)); // nan is skipped.
    greatest = std::fmax(greatest, ids->At(point));
  }
  if (least < greatest)
  {
    throw InputError("points with surface IDs from " + std::to_string(std::int64_t(least)) + " to " +
      std::to_string(std::int64_t(greatest)) + ", expected one ID in a horizon");
  }
  return ToInteger(least, PointArray::SurfaceId, 0);
}

LatticeHorizon ReadVoxels(const Horizon& horizon, int surfaceId)
{
  const LatticePoints points = ReadColumns(horizon);
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

/// All horizons must have the cells and vertical indices of the first one.
void CheckLattice(const NamedHorizon& horizon, const NamedHorizon& first)
{
  const SparseMatrixSize size = ReadMatrixSize(horizon.Data);
  CountColumns(size[0], size[1], horizon.Data.NumberOfPoints());
  const std::array<double, 2> scale = ReadVerticalScale(horizon.Data);
  const std::array<double, 2> firstScale = ReadVerticalScale(first.Data);
  if (scale != firstScale)
  {
    std::ostringstream text;
    text << "vertical indices from " << scale[0] << " in steps of " << scale[1] << ", expected from " << firstScale[0]
         << " in steps of " << firstScale[1] << " as in " << first.Name
         << "; with VerticalStep, readers give all horizons the same";
    throw InputError(text.str());
  }
  const SparseMatrixSize firstSize = ReadLatticeDimensions(first.Data);
  if (size != firstSize)
  {
    throw InputError(
      "a lattice of " + NumberText(size) + " cells, expected " + NumberText(firstSize) + " as in " + first.Name);
  }
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

//----------------------------------------------------------------------------------------------------------------------
WrittenMatrix MakeSparseMatrix(const std::vector<NamedHorizon>& horizons, const Monitor& monitor)
{
  WrittenMatrix written;
  SparseMatrix& matrix = written.Matrix;
  std::vector<std::optional<int>> given; // surface IDs
  std::set<int> ids;
  bool isUp = false;
  for (const NamedHorizon& horizon : horizons)
  {
    PrefixErrors(horizon.Name,
      [&]()
      {
        CheckLattice(horizon, horizons.front());
        isUp = isUp || FirstValue(horizon.Data.FieldData, FieldArray::VerticalDirection) > 0.0;
        given.push_back(ReadSurfaceId(horizon.Data));
        if (given.back())
        {
          ids.insert(*given.back());
        }
      });
  }
  matrix.Size = ReadLatticeDimensions(horizons.front().Data);
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    monitor.Progress(double(n) / double(horizons.size()));
    const int id = given[n] ? *given[n] : TakeFreeId(ids);
    PrefixErrors(horizons[n].Name, [&]() { matrix.Horizons.push_back(ReadVoxels(horizons[n].Data, id)); });
  }
  if (isUp)
  {
    written.Warnings.emplace_back(
      "elevations, which the format cannot tell from depths: read them with VerticalDirection Up");
  }
  return written;
}
}
