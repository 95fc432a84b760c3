// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonData.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "HorizonPoints.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 16384; // points that a thread takes at a time

// How far from a whole column, in lattice units, a point may be to count as being on it. Rounding of world coordinates
// is far below, and no other column could be meant.
constexpr double ColumnTolerance = 0.01;

// More voxels than any horizon has. Averages add up as many places in sub-voxels, below 2^29 each, which fits 64 bits.
constexpr std::int64_t MostVoxels = std::int64_t(1) << 32;

/// An array of numbers by its name; null when there is none of that name.
vtkDataArray* FindNumbers(vtkFieldData* data, const char* name)
{
  vtkAbstractArray* const array = data->GetAbstractArray(name);
  vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
  if (array && !numbers)
  {
    throw InputError(
      std::string("an array ") + name + " of type " + array->GetDataTypeAsString() + ", expected numbers");
  }
  return numbers;
}

vtkDataArray* FindFieldArray(vtkDataObject* horizon, const char* name, int values)
{
  vtkDataArray* const array = FindNumbers(horizon->GetFieldData(), name);
  const vtkIdType found = array ? array->GetNumberOfValues() : 0;
  if (found != values)
  {
    throw InputError((array ? std::to_string(found) + " values in the field data array " : "no field data array ") +
      name + ", expected " + std::to_string(values) +
      " values that place the horizon on its lattice, as the reader of sparse-matrix files writes them");
  }
  return array;
}

template <typename Number>
std::string Text(Number number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// Whether a number can be stored as another type without a change.
template <typename Number, typename Value>
bool Fits(Value value)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    const double limit = std::ldexp(1.0, std::numeric_limits<Number>::digits);
    return value >= -limit && value < limit && value == std::floor(value);
  }
  else
  {
    const Number converted = static_cast<Number>(value);
    return static_cast<Value>(converted) == value && (converted < 0) == (value < 0);
  }
}

/// A point array of one number per point; null when there is none of that name.
vtkDataArray* FindPointArray(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = FindNumbers(horizon->GetPointData(), name);
  if (array && array->GetNumberOfComponents() != 1)
  {
    throw InputError("point array " + std::string(name) + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected 1");
  }
  if (array && array->GetNumberOfTuples() != horizon->GetNumberOfPoints())
  {
    throw InputError("point array " + std::string(name) + " with " + std::to_string(array->GetNumberOfTuples()) +
      " values, expected one for each of the " + std::to_string(horizon->GetNumberOfPoints()) + " points");
  }
  return array;
}

/// The values of an array as whole numbers.
template <typename Number>
std::vector<Number> CopyValues(vtkDataArray* array)
{
  std::vector<Number> values;
  values.reserve(std::size_t(array->GetNumberOfTuples()));
  const auto copy = [&](auto* typedArray)
  {
    for (const vtk::GetAPIType<std::remove_pointer_t<decltype(typedArray)>> value :
      vtk::DataArrayValueRange<1>(typedArray))
    {
      if (!Fits<Number>(value))
      {
        throw InputError(std::string(array->GetName()) + ' ' + Text(+value) + " at point " +
          std::to_string(values.size()) + ", expected a whole number of " +
          std::to_string(std::numeric_limits<Number>::digits + 1) + " bits");
      }
      values.push_back(static_cast<Number>(value));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
  return values;
}

/// How many lattice units points rise for each vertical index, by a line through some of them; 1 when they are too
/// level to tell, or there are no vertical indices.
double MeasureStretch(vtkPolyData* horizon, const std::vector<double>& height)
{
  vtkDataArray* const index = FindNumbers(horizon->GetPointData(), PointArray::VerticalIndex);
  if (!index || index->GetNumberOfTuples() != vtkIdType(height.size()))
  {
    return 1.0;
  }
  constexpr std::size_t Enough = 1000;
  std::vector<Eigen::Vector2d> pairs;
  for (std::size_t point = 0; point < height.size(); point += height.size() / Enough + 1)
  {
    pairs.emplace_back(index->GetComponent(vtkIdType(point), 0), height[point]);
  }
  const Eigen::Vector2d sum = std::accumulate(pairs.begin(), pairs.end(), Eigen::Vector2d(0.0, 0.0));
  const Eigen::Vector2d mean = sum / double(pairs.size());
  double square = 0.0;
  double product = 0.0;
  for (const Eigen::Vector2d& pair : pairs)
  {
    square += (pair.x() - mean.x()) * (pair.x() - mean.x());
    product += (pair.x() - mean.x()) * (pair.y() - mean.y());
  }
  constexpr double LeastDeviation = 2.0; // vertical indices: with less, rounding and real z could decide
  return square > LeastDeviation * LeastDeviation * double(pairs.size()) ? product / square : 1.0;
}

/// Transform moves points, and leaves the lattice in the field data as it is.
void CheckHeights(vtkPolyData* horizon, const std::vector<double>& height)
{
  // Real z is not a multiple of the vertical index, but in a survey about as long everywhere.
  constexpr double MostStretch = 2.0;
  const double stretch = MeasureStretch(horizon, height);
  if (stretch < 1.0 / MostStretch || stretch > MostStretch)
  {
    throw InputError("points rise by " + Text(stretch) +
      " lattice units for each vertical index, expected 1: where points were moved or scaled, as by Transform, "
      "the lattice in LatticeToWorld is no longer theirs");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
double FieldValue(vtkDataArray* array, int n)
{
  const int components = array->GetNumberOfComponents();
  return array->GetComponent(n / components, n % components);
}

//----------------------------------------------------------------------------------------------------------------------
std::array<int, 3> ReadLatticeDimensions(vtkDataObject* horizon)
{
  vtkDataArray* const size = FindFieldArray(horizon, FieldArray::LatticeDimensions, 3);
  std::array<int, 3> dimensions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = FieldValue(size, axis);
    if (!Fits<int>(cells))
    {
      throw InputError(std::string(FieldArray::LatticeDimensions) + " with " + Text(cells) +
        " cells along an axis, expected a whole number of 32 bits");
    }
    dimensions[std::size_t(axis)] = int(cells);
  }
  return dimensions;
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Matrix4d ReadLatticeMap(vtkDataObject* horizon)
{
  vtkDataArray* const map = FindFieldArray(horizon, FieldArray::LatticeToWorld, 16);
  Eigen::Matrix4d toWorld;
  for (int n = 0; n < 16; ++n)
  {
    toWorld(n / 4, n % 4) = FieldValue(map, n);
  }
  return toWorld;
}

//----------------------------------------------------------------------------------------------------------------------
Lattice ReadLattice(vtkDataObject* horizon)
{
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  return Lattice(dimensions, ReadLatticeMap(horizon));
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadPoints(vtkPolyData* horizon)
{
  const vtkIdType size = horizon->GetNumberOfPoints();
  if (size > std::numeric_limits<PointId>::max() / 4)
  {
    throw InputError(std::to_string(size) + " points, expected less than 2^29 in one horizon");
  }
  const vtkIdType hidden = size - CountVisiblePoints(horizon);
  if (hidden > 0)
  {
    throw InputError(std::to_string(hidden) +
      " hidden points by the array vtkGhostType, expected none: only Horizon Exterior Boundary leaves them out");
  }
  if (horizon->GetCellData()->HasArray(CellArray::CellSize))
  {
    throw InputError("the cells of a simplification, as ShowCells gives them to look at, expected its points");
  }
  LatticePoints points;
  points.Grid = ReadLattice(horizon);
  points.Plane.resize(std::size_t(size));
  points.Height.resize(std::size_t(size));
  ParallelFor(size, Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      Eigen::Vector3d world;
      for (vtkIdType point = first; point < last; ++point)
      {
        horizon->GetPoint(point, world.data());
        const Eigen::Vector3d place = points.Grid.ToLattice(world);
        points.Plane[std::size_t(point)] = points.Grid.ToSubVoxels(place, PointId(point));
        points.Height[std::size_t(point)] = place.z();
      }
    });
  CheckHeights(horizon, points.Height);
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> ToColumns(const LatticePoints& points)
{
  std::vector<PlanePoint> columns;
  columns.reserve(points.Plane.size());
  for (const PlanePoint& place : points.Plane)
  {
    const double x = points.Grid.ToLatticeUnits(place.X);
    const double y = points.Grid.ToLatticeUnits(place.Y);
    if (std::abs(x - std::round(x)) > ColumnTolerance || std::abs(y - std::round(y)) > ColumnTolerance)
    {
      throw InputError("point " + std::to_string(columns.size()) + " at (" + std::to_string(x) + ", " +
        std::to_string(y) + ") in lattice units, expected whole columns, as points have them before they are merged");
    }
    columns.push_back({ std::int32_t(std::lround(x)), std::int32_t(std::lround(y)) });
  }
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
Loops ReadBoundary(vtkPolyData* horizon)
{
  Loops loops;
  vtkCellArray* const lines = horizon->GetLines();
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType line = 0; lines && line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellAtId(line, size, points);
    if (size < 2 || points[0] != points[size - 1])
    {
      throw InputError("line " + std::to_string(line) + " with " + std::to_string(size) +
        " points that is not closed, expected only boundary loops: polylines whose last point is their first");
    }
    const auto wrong = std::find_if(
      points, points + size, [horizon](vtkIdType id) { return id < 0 || id >= horizon->GetNumberOfPoints(); });
    if (wrong != points + size)
    {
      throw InputError("point id " + std::to_string(*wrong) + " in line " + std::to_string(line) + ", expected 0 to " +
        std::to_string(horizon->GetNumberOfPoints() - 1));
    }
    std::for_each(points, points + size - 1, [&loops](vtkIdType point) { loops.Append(PointId(point)); });
    loops.Close();
  }
  if (loops.Size() == 0)
  {
    throw InputError("no boundary loops, expected a closed polyline around each patch, as Horizon Exterior Boundary "
                     "makes them");
  }
  return loops;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int32_t> ReadPatches(vtkPolyData* horizon)
{
  vtkDataArray* const patches = FindPointArray(horizon, PointArray::PatchId);
  if (!patches)
  {
    throw InputError(std::string("no point array ") + PointArray::PatchId +
      ", expected the patch number of each point, as Horizon Exterior Boundary makes it");
  }
  return CopyValues<std::int32_t>(patches);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> ReadCounts(vtkPolyData* horizon)
{
  vtkDataArray* const counts = FindPointArray(horizon, PointArray::PointCount);
  if (!counts)
  {
    return std::vector<std::int64_t>(std::size_t(horizon->GetNumberOfPoints()), 1);
  }
  std::vector<std::int64_t> values = CopyValues<std::int64_t>(counts);
  double sum = 0.0;
  for (std::size_t point = 0; point < values.size(); ++point)
  {
    sum += double(values[point]);
    if (values[point] < 0 || sum > double(MostVoxels))
    {
      throw InputError(std::string(PointArray::PointCount) + ' ' + std::to_string(values[point]) + " at point " +
        std::to_string(point) + ", expected no negative numbers, and at most 2^32 in all");
    }
  }
  return values;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 3>> ReadTriangles(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfStrips() > 0)
  {
    throw InputError(
      std::to_string(mesh->GetNumberOfStrips()) + " triangle strips, expected triangles: apply Triangulate before");
  }
  vtkCellArray* const polys = mesh->GetPolys();
  std::vector<std::array<PointId, 3>> triangles;
  triangles.reserve(std::size_t(mesh->GetNumberOfPolys()));
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    polys->GetCellAtId(cell, size, corners);
    if (size != 3)
    {
      throw InputError("polygon " + std::to_string(cell) + " with " + std::to_string(size) +
        " corners, expected triangles: apply Triangulate before");
    }
    const auto [least, greatest] = std::minmax({ corners[0], corners[1], corners[2] });
    if (least < 0 || greatest >= mesh->GetNumberOfPoints())
    {
      throw InputError("point ids " + std::to_string(least) + " to " + std::to_string(greatest) + " in triangle " +
        std::to_string(cell) + ", expected 0 to " + std::to_string(mesh->GetNumberOfPoints() - 1));
    }
    triangles.push_back({ PointId(corners[0]), PointId(corners[1]), PointId(corners[2]) });
  }
  return triangles;
}

//----------------------------------------------------------------------------------------------------------------------
BoundedHorizon ReadPatchesAndBoundary(vtkPolyData* horizon, std::vector<PlanePoint> plane, const Lattice& grid)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = grid.SubVoxelsPerColumn();
  result.Plane = std::move(plane);
  result.Patch = ReadPatches(horizon);
  result.Boundary = ReadBoundary(horizon);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
BoundedHorizon ReadBoundedHorizon(vtkPolyData* horizon, LatticePoints points)
{
  BoundedHorizon result = ReadPatchesAndBoundary(horizon, std::move(points.Plane), points.Grid);
  result.Height = std::move(points.Height);
  result.Count = ReadCounts(horizon);
  return result;
}
}
