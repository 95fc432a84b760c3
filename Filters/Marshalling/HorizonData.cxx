// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonData.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/Parallel.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 16384; // points that a thread takes at a time

vtkDataArray* FindFieldArray(vtkPolyData* horizon, const char* name, int values)
{
  vtkDataArray* const array = horizon->GetFieldData()->GetArray(name);
  const vtkIdType found = array ? array->GetNumberOfValues() : 0;
  if (found != values)
  {
    throw InputError((array ? std::to_string(found) + " values in the field data array " : "no field data array ") +
      name + ", expected " + std::to_string(values) +
      " values that place the horizon on its lattice, as the reader of sparse-matrix files writes them");
  }
  return array;
}

double FieldValue(vtkDataArray* array, int n)
{
  const int components = array->GetNumberOfComponents();
  return array->GetComponent(n / components, n % components);
}

/// A point array of one number per point.
vtkDataArray* FindPointArray(vtkPolyData* horizon, const char* name)
{
  vtkDataArray* const array = horizon->GetPointData()->GetArray(name);
  if (array && array->GetNumberOfComponents() != 1)
  {
    throw InputError("point array " + std::string(name) + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected 1");
  }
  return array;
}

template <typename Number>
std::vector<Number> CopyValues(vtkDataArray* array)
{
  std::vector<Number> values;
  values.reserve(std::size_t(array->GetNumberOfTuples()));
  const auto copy = [&values](auto* typedArray)
  {
    for (const auto value : vtk::DataArrayValueRange<1>(typedArray))
    {
      values.push_back(static_cast<Number>(value));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
  {
    copy(array);
  }
  return values;
}
}

//----------------------------------------------------------------------------------------------------------------------
Lattice ReadLattice(vtkPolyData* horizon)
{
  vtkDataArray* const size = FindFieldArray(horizon, FieldArray::LatticeDimensions, 3);
  vtkDataArray* const map = FindFieldArray(horizon, FieldArray::LatticeToWorld, 16);
  std::array<int, 3> dimensions;
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[std::size_t(axis)] = int(FieldValue(size, axis));
  }
  Eigen::Matrix4d toWorld;
  for (int n = 0; n < 16; ++n)
  {
    toWorld(n / 4, n % 4) = FieldValue(map, n);
  }
  return Lattice(dimensions, toWorld);
}

//----------------------------------------------------------------------------------------------------------------------
LatticePoints ReadPoints(vtkPolyData* horizon)
{
  const vtkIdType size = horizon->GetNumberOfPoints();
  if (size > std::numeric_limits<PointId>::max() / 4)
  {
    throw InputError(std::to_string(size) + " points, expected less than 2^29 in one horizon");
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
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PlanePoint> ToColumns(const LatticePoints& points)
{
  // A hundredth of a column is far beyond rounding in world coordinates, and no column could be meant but the nearest.
  const double tolerance = 0.01;
  std::vector<PlanePoint> columns;
  columns.reserve(points.Plane.size());
  for (const PlanePoint& place : points.Plane)
  {
    const double x = points.Grid.ToLatticeUnits(place.X);
    const double y = points.Grid.ToLatticeUnits(place.Y);
    if (std::abs(x - std::round(x)) > tolerance || std::abs(y - std::round(y)) > tolerance)
    {
      throw InputError("point " + std::to_string(columns.size()) + " at (" + std::to_string(x) + ", " +
        std::to_string(y) +
        ") in lattice units, expected whole columns: the boundary is found before points are "
        "merged");
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
  return counts ? CopyValues<std::int64_t>(counts)
                : std::vector<std::int64_t>(std::size_t(horizon->GetNumberOfPoints()), 1);
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
