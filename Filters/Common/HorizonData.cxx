// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonData.h"

#include "Common/Base/Errors.h"
#include "Common/Base/LargePages.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"
#include "CutData.h"
#include "HorizonPoints.h"

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

const DataArray& FindFieldArray(const Horizon& horizon, const char* name, int values)
{
  const DataArray* const array = FindNumbers(horizon.FieldData, name);
  const std::int64_t found = array ? array->Size() : 0;
  if (found != values)
  {
    throw InputError((array ? std::to_string(found) + " values in the field data array " : "no field data array ") +
      name + ", expected " + std::to_string(values) +
      " values that place the horizon on its lattice, as readers of horizons write them: Horizon From Points finds the "
      "lattice of other points");
  }
  return *array;
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
const DataArray* FindPointArray(const Horizon& horizon, const char* name)
{
  const DataArray* const array = FindNumbers(horizon.PointData, name);
  if (array && array->Components() != 1)
  {
    throw InputError(
      "point array " + std::string(name) + " with " + std::to_string(array->Components()) + " components, expected 1");
  }
  return array;
}

template <typename Number, typename Value>
Number Convert(Value value, const DataArray& array, std::size_t point)
{
  if (!Fits<Number>(value))
  {
    throw InputError(array.Name + ' ' + Text(+value) + " at point " + std::to_string(point) +
      ", expected a whole number of " + std::to_string(std::numeric_limits<Number>::digits + 1) + " bits");
  }
  return static_cast<Number>(value);
}

template <typename Number>
std::vector<Number> CopyValues(const DataArray& array)
{
  std::vector<Number> values = LargeVector<Number>(std::size_t(array.Tuples()));
  array.WithNumbers(
    [&](const auto* given)
    {
      ParallelFor(std::int64_t(values.size()), Grain,
        [&](std::int64_t first, std::int64_t last)
        {
          for (auto point = std::size_t(first); point < std::size_t(last); ++point)
          {
            values[point] = Convert<Number>(given[point], array, point);
          }
        });
    });
  return values;
}

/// Refuses a repeated edge, which would double the surface. An edge in both directions is allowed: it is a spur or a
/// bridge.
void CheckSides(const Loops& loops, std::int64_t numberOfPoints)
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
std::array<int, 3> ReadLatticeDimensions(const Horizon& horizon)
{
  const DataArray& size = FindFieldArray(horizon, FieldArray::LatticeDimensions, 3);
  std::array<int, 3> dimensions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = size.Value(axis);
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
Eigen::Matrix4d ReadLatticeMap(const Horizon& horizon)
{
  const DataArray& map = FindFieldArray(horizon, FieldArray::LatticeToWorld, 16);
  Eigen::Matrix4d toWorld;
  for (int n = 0; n < 16; ++n)
  {
    toWorld(n / 4, n % 4) = map.Value(n);
  }
  return toWorld;
}

//----------------------------------------------------------------------------------------------------------------------
Lattice ReadLattice(const Horizon& horizon)
{
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  return Lattice(dimensions, ReadLatticeMap(horizon));
}

//----------------------------------------------------------------------------------------------------------------------
Loops ReadBoundary(const Horizon& horizon)
{
  Loops loops;
  const Cells& lines = horizon.Lines;
  for (std::int64_t line = 0; line < lines.Size(); ++line)
  {
    const std::int64_t size = lines.Length(line);
    if (size < 2 || lines.At(line, 0) != lines.At(line, size - 1))
    {
      throw InputError("line " + std::to_string(line) + " with " + std::to_string(size) +
        " points that is not closed, expected only boundary loops: polylines whose last point is their first");
    }
    for (std::int64_t n = 0; n < size; ++n)
    {
      const std::int64_t point = lines.At(line, n);
      if (point < 0 || point >= horizon.NumberOfPoints())
      {
        throw InputError("point id " + std::to_string(point) + " in line " + std::to_string(line) + ", expected 0 to " +
          std::to_string(horizon.NumberOfPoints() - 1));
      }
      if (n + 1 < size)
      {
        loops.Append(PointId(point));
      }
    }
    loops.Close();
  }
  if (loops.Size() == 0)
  {
    throw InputError("no boundary loops, expected a closed polyline around each patch, as Horizon Exterior Boundary "
                     "makes them");
  }
  CheckSides(loops, horizon.NumberOfPoints());
  return loops;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int32_t> ReadPatches(const Horizon& horizon)
{
  const DataArray* const patches = FindPointArray(horizon, PointArray::PatchId);
  if (!patches)
  {
    throw InputError(std::string("no point array ") + PointArray::PatchId +
      ", expected the patch number of each point, as Horizon Exterior Boundary makes it");
  }
  return CopyValues<std::int32_t>(*patches);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> ReadCounts(const Horizon& horizon)
{
  const DataArray* const counts = FindPointArray(horizon, PointArray::PointCount);
  if (!counts)
  {
    return {};
  }
  std::vector<std::int64_t> values = CopyValues<std::int64_t>(*counts);
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
void RequireAllPoints(const Horizon& horizon)
{
  if (horizon.Polygons.Size() > 0 && horizon.PointData.Has(PointArray::PointCount))
  {
    throw InputError("a mesh of " + std::to_string(horizon.Polygons.Size()) +
      " triangles, already simplified, expected all points of the horizon, from which the error is measured");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 3>> ReadTriangles(const Horizon& mesh)
{
  if (mesh.Strips > 0)
  {
    throw InputError(std::to_string(mesh.Strips) + " triangle strips, expected triangles: apply Triangulate first");
  }
  const Cells& polygons = mesh.Polygons;
  std::vector<std::array<PointId, 3>> triangles;
  triangles.reserve(std::size_t(polygons.Size()));
  for (std::int64_t cell = 0; cell < polygons.Size(); ++cell)
  {
    if (polygons.Length(cell) != 3)
    {
      throw InputError("polygon " + std::to_string(cell) + " with " + std::to_string(polygons.Length(cell)) +
        " corners, expected triangles: apply Triangulate first");
    }
    const std::array<std::int64_t, 3> corners = { polygons.At(cell, 0), polygons.At(cell, 1), polygons.At(cell, 2) };
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    if (*least < 0 || *greatest >= mesh.NumberOfPoints())
    {
      throw InputError("point ids " + std::to_string(*least) + " to " + std::to_string(*greatest) + " in triangle " +
        std::to_string(cell) + ", expected 0 to " + std::to_string(mesh.NumberOfPoints() - 1));
    }
    triangles.push_back({ PointId(corners[0]), PointId(corners[1]), PointId(corners[2]) });
  }
  return triangles;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::array<PointId, 3>> ReadOpenTriangles(const Horizon& mesh)
{
  std::vector<std::array<PointId, 3>> triangles = ReadTriangles(mesh);
  const DataArray* const faults = FindNumbers(mesh.CellData, CellArray::Fault);
  if (!faults)
  {
    return triangles;
  }
  RequireTuples(*faults, mesh.NumberOfCells(), "cells");
  const std::int64_t first = mesh.Vertices.Size() + mesh.Lines.Size();
  std::vector<std::array<PointId, 3>> open;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    if (faults->At(first + std::int64_t(n)) == 0.0)
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
