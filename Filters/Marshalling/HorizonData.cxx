// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonData.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "CutData.h"
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
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Exceeds any horizon. Sums of this many sub-voxel coordinates, below 2^29 each, fit 64 bits.
constexpr std::int64_t MostVoxels = std::int64_t(1) << 32;

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

/// Null without the array; throws InputError on several components.
vtkDataArray* FindPointArray(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = FindNumbers(horizon->GetPointData(), name);
  if (array && array->GetNumberOfComponents() != 1)
  {
    throw InputError("point array " + std::string(name) + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected 1");
  }
  return array;
}

template <typename Number, typename Value>
Number Convert(Value value, vtkDataArray* array, std::size_t point)
{
  if (!Fits<Number>(value))
  {
    throw InputError(std::string(array->GetName()) + ' ' + Text(+value) + " at point " + std::to_string(point) +
      ", expected a whole number of " + std::to_string(std::numeric_limits<Number>::digits + 1) + " bits");
  }
  return static_cast<Number>(value);
}

template <typename Number>
std::vector<Number> CopyValues(vtkDataArray* array)
{
  std::vector<Number> values = LargeVector<Number>(std::size_t(array->GetNumberOfTuples()));
  const auto copy = [&](auto* typedArray)
  {
    using Value = vtk::GetAPIType<std::remove_pointer_t<decltype(typedArray)>>;
    const auto given = vtk::DataArrayValueRange<1>(typedArray);
    ParallelFor(std::int64_t(values.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto point = std::size_t(first); point < std::size_t(last); ++point)
        {
          values[point] = Convert<Number>(Value(given[vtkIdType(point)]), array, point);
        }
      });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
  return values;
}

/// Refuses a repeated edge, which would double the surface. An edge in both directions is allowed: it is a spur or a
/// bridge.
void CheckSides(const Loops& loops, vtkIdType numberOfPoints)
{
  std::vector<PointId> firstEnd = LargeVector(std::size_t(numberOfPoints), NoPoint);
  std::set<std::pair<PointId, PointId>> others; // Only points that loops visit again have entries.
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    PointId from = *(loops.end(loop) - 1);
    for (const PointId* end = loops.begin(loop); end != loops.end(loop); from = *end++)
    {
      PointId& first = firstEnd[std::size_t(from)];
      const bool isFirst = first == NoPoint;
      first = isFirst ? *end : first;
      if (!isFirst && (first == *end || !others.insert({ from, *end }).second))
      {
        throw InputError("line " + std::to_string(loop) + " from point " + std::to_string(from) + " to point " +
          std::to_string(*end) + " repeats an edge, expected each edge of a loop once, with the surface to its right");
      }
    }
  }
}

/// Rounded outwards: places may lie between columns.
PlaneBox ColumnsAround(PlaneBox box, std::int32_t subVoxelsPerColumn)
{
  if (!box.IsEmpty())
  {
    box.Least = { box.Least.X / subVoxelsPerColumn - 1, box.Least.Y / subVoxelsPerColumn - 1 };
    box.Greatest = { box.Greatest.X / subVoxelsPerColumn + 1, box.Greatest.Y / subVoxelsPerColumn + 1 };
  }
  return box;
}
}

//----------------------------------------------------------------------------------------------------------------------
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
    dimensions[axis] = int(cells);
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
  CheckSides(loops, horizon->GetNumberOfPoints());
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
    return {};
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
void RequireAllPoints(vtkPolyData* horizon)
{
  if (horizon->GetNumberOfPolys() > 0 && horizon->GetPointData()->HasArray(PointArray::PointCount))
  {
    throw InputError("a mesh of " + std::to_string(horizon->GetNumberOfPolys()) +
      " triangles, already simplified, expected all points of the horizon, from which the error is measured");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 3>> ReadTriangles(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfStrips() > 0)
  {
    throw InputError(
      std::to_string(mesh->GetNumberOfStrips()) + " triangle strips, expected triangles: apply Triangulate first");
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
        " corners, expected triangles: apply Triangulate first");
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
std::vector<std::array<PointId, 3>> ReadOpenTriangles(vtkPolyData* mesh)
{
  std::vector<std::array<PointId, 3>> triangles = ReadTriangles(mesh);
  vtkDataArray* const faults = FindNumbers(mesh->GetCellData(), CellArray::Fault);
  if (!faults)
  {
    return triangles;
  }
  RequireTuples(faults, mesh->GetNumberOfCells(), "cells");
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  std::vector<std::array<PointId, 3>> open;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    if (faults->GetComponent(first + vtkIdType(n), 0) == 0.0)
    {
      open.push_back(triangles[n]);
    }
  }
  return open;
}

//----------------------------------------------------------------------------------------------------------------------
BoundedHorizon ReadPatchesAndBoundary(const LatticePoints& points)
{
  BoundedHorizon result;
  if (points.AreMerged)
  {
    result.SubVoxelsPerColumn = points.Lattice.SubVoxelsPerColumn();
    result.Plane = ToSubVoxels(points);
  }
  else
  {
    result.Plane.assign(points.Column.begin(), points.Column.end());
  }
  result.Patch = ReadPatches(points.Horizon);
  result.Boundary = ReadBoundary(points.Horizon);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
BoundedHorizon ReadBoundedHorizon(LatticePoints points)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = points.Lattice.SubVoxelsPerColumn();
  if (points.AreMerged)
  {
    result.Plane = ToSubVoxels(points);
  }
  else
  {
    result.Columns = points.Column;
  }
  result.Height = std::move(points.Height);
  result.Patch = ReadPatches(points.Horizon);
  result.Boundary = ReadBoundary(points.Horizon);
  result.Count = ReadCounts(points.Horizon);
  result.Cuts = ShareCuts(points.Horizon, ColumnsAround(result.Places().Box(), result.SubVoxelsPerColumn));
  return result;
}
}
