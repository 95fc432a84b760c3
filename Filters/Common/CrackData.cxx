// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CrackData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"
#include "CutData.h"
#include "Filters/Algorithms/FaultClosing/FaultClosing.h"
#include "Filters/Algorithms/Triangulation/TriangleQuality.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "LatticePoints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int OpenEndComponents = 4; // i and j of both points

bool HasCuts(const ArrayTable& data)
{
  const DataArray* const links = FindFaultedLinks(data);
  return links && links->Tuples() > 0;
}

/// Throws InputError unless the value is a whole number of at least 0.
int ReadLinkNumber(const DataArray* const array, std::int64_t tuple, int component)
{
  const double value = array->At(tuple, component);
  if (!(value >= 0.0 && value <= MostColumnsPerSide && value == std::floor(value)))
  {
    std::ostringstream text;
    text << array->Name << ' ' << value << " in tuple " << tuple << ", expected a whole number, at least 0";
    throw InputError(text.str());
  }
  return int(value);
}

/// Returns null without the array, and throws InputError on another number of components.
const DataArray* FindTuples(const ArrayTable& data, const char* name, int components)
{
  const DataArray* const array = FindNumbers(data, name);
  if (array && array->Components() != components)
  {
    throw InputError("field data array " + std::string(name) + " with " + std::to_string(array->Components()) +
      " components, expected " + std::to_string(components));
  }
  return array;
}

/// Version 0.2 used another name.
std::vector<std::array<PlanePoint, 2>> ReadOpenEnds(const ArrayTable& data)
{
  std::vector<std::array<PlanePoint, 2>> openEnds;
  const char* const name =
    data.Has(FieldArray::CrackOpenEnds) ? FieldArray::CrackOpenEnds : FieldArray::OldCrackOpenEnds;
  const DataArray* const array = FindTuples(data, name, OpenEndComponents);
  for (std::int64_t n = 0; array && n < array->Tuples(); ++n)
  {
    const auto read = [&](int component) { return ReadLinkNumber(array, n, component); };
    openEnds.push_back({ PlanePoint{ read(0), read(1) }, PlanePoint{ read(2), read(3) } });
  }
  return openEnds;
}

/// Points of loops by column; NoPoint where no loop has a point.
using OpenEndPoints = std::map<PlanePoint, PointId>;

OpenEndPoints FindOpenEndPoints(
  const std::vector<std::array<PlanePoint, 2>>& openEnds, PlanePoints columns, const Loops& boundary)
{
  OpenEndPoints points;
  for (const auto& [from, to] : openEnds)
  {
    points[from] = NoPoint;
    points[to] = NoPoint;
  }
  if (!points.empty())
  {
    boundary.ForEachPoint(
      [&](PointId point)
      {
        const auto found = points.find(columns[point]);
        if (found != points.end())
        {
          found->second = point;
        }
      });
  }
  return points;
}

/// Cracks refer to loops by number, so no loop may be missing.
void CheckNumberOfLoops(const ArrayTable& data, const Loops& boundary)
{
  const DataArray* const patches = FindTuples(data, FieldArray::NumberOfPatches, 1);
  const DataArray* const holes = FindTuples(data, FieldArray::NumberOfHoles, 1);
  if (!patches || !holes || patches->Value(0) + holes->Value(0) != double(boundary.Size()))
  {
    throw InputError(std::to_string(boundary.Size()) + " boundary loops with the field data array " +
      FieldArray::CrackLoops + ", expected as many as " + FieldArray::NumberOfPatches + " and " +
      FieldArray::NumberOfHoles + " say: close faults of whole horizons");
  }
}

Cracks ReadCracks(const Horizon& horizon, const Loops& boundary)
{
  Cracks cracks;
  const std::vector<std::array<PlanePoint, 2>> openEnds = ReadOpenEnds(horizon.FieldData);
  const OpenEndPoints points = FindOpenEndPoints(openEnds, ColumnsOf(horizon), boundary);
  for (const std::array<PlanePoint, 2>& openEnd : openEnds)
  {
    cracks.OpenEnds.push_back({ points.at(openEnd[0]), points.at(openEnd[1]) });
    for (const PlanePoint& column : openEnd)
    {
      if (points.at(column) == NoPoint)
      {
        throw InputError("open end of a crack at column (" + std::to_string(column.X) + ", " +
          std::to_string(column.Y) + "), expected a point of a boundary loop");
      }
    }
  }
  const DataArray* const loops = FindTuples(horizon.FieldData, FieldArray::CrackLoops, 1);
  for (std::int64_t n = 0; loops && n < loops->Tuples(); ++n)
  {
    cracks.Loops.push_back(std::size_t(ReadLinkNumber(loops, n, 0)));
  }
  if (!cracks.Loops.empty())
  {
    CheckNumberOfLoops(horizon.FieldData, boundary);
  }
  return cracks;
}

/// New triangles have nan in all other arrays.
void ExtendCellData(const TriangleQuality& quality, std::size_t triangles, ArrayTable& data)
{
  const std::vector<std::pair<const char*, const RawVector<float>*>> known = {
    { CellArray::Compactness, &quality.Compactness }, { CellArray::Quality, &quality.Shape }
  };
  const ArrayTable before = data;
  for (const DataArray& array : before)
  {
    const auto found =
      std::find_if(known.begin(), known.end(), [&array](const auto& named) { return array.Name == named.first; });
    DataArray extended = array.NewLike(array.Tuples() + std::int64_t(triangles));
    std::memcpy(extended.Data(), array.Data(), std::size_t(array.Tuples()) * array.BytesOfTuple());
    for (std::size_t triangle = 0; triangle < triangles; ++triangle)
    {
      extended.Set(array.Tuples() + std::int64_t(triangle), 0,
        found == known.end() ? std::numeric_limits<double>::quiet_NaN() : double((*found->second)[triangle]));
    }
    data.Add(std::move(extended));
  }
}

/// Keeps the size of numbers.
template <typename T>
Cells AppendTriangles(const Cells& cells, const RawVector<PointId>& triangles)
{
  const DataArray& points = cells.Points;
  HeapArray<T> offsets;
  HeapArray<T> corners;
  offsets.append(cells.Offsets.As<T>(), cells.Offsets.As<T>() + cells.Offsets.Tuples());
  corners.append(points.As<T>(), points.As<T>() + points.Tuples());
  std::copy(triangles.begin(), triangles.end(), corners.Extend(triangles.size()));
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    offsets.push_back(offsets.back() + 3);
  }
  return { DataArray::Take(offsets), DataArray::Take(corners) };
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteCracks(const Cracks& cracks, Horizon& horizon)
{
  ArrayTable& data = horizon.FieldData;
  data.Remove(FieldArray::OldCrackOpenEnds);
  if (!HasCuts(data))
  {
    data.Remove(FieldArray::CrackOpenEnds);
    data.Remove(FieldArray::CrackLoops);
    return;
  }
  const PlanePoints columns = ColumnsOf(horizon);
  std::vector<std::array<int, OpenEndComponents>> tuples;
  for (const Edge& openEnd : cracks.OpenEnds)
  {
    const PlanePoint from = columns[openEnd.From];
    const PlanePoint to = columns[openEnd.To];
    tuples.push_back({ from.X, from.Y, to.X, to.Y });
  }
  std::sort(tuples.begin(), tuples.end()); // The result must not depend on the order of points.
  DataArray openEnds = NewArray<int>(FieldArray::CrackOpenEnds, std::int64_t(tuples.size()), OpenEndComponents);
  for (std::size_t n = 0; n < tuples.size(); ++n)
  {
    std::copy(tuples[n].begin(), tuples[n].end(), openEnds.As<int>() + OpenEndComponents * n);
  }
  data.Add(std::move(openEnds));
  AddArray<std::int64_t>(data, FieldArray::CrackLoops, cracks.Loops);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> ReadPointsOfOpenEnds(const Horizon& horizon, PlanePoints columns, const Loops& boundary)
{
  const std::vector<std::array<PlanePoint, 2>> openEnds = ReadOpenEnds(horizon.FieldData);
  std::vector<PointId> found;
  for (const auto& [column, point] : FindOpenEndPoints(openEnds, columns, boundary))
  {
    if (point != NoPoint)
    {
      found.push_back(point);
    }
  }
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
void CloseMesh(const std::vector<PlanePoint>& plane, const Lattice& lattice, const Loops& boundary, Horizon& mesh,
  const Monitor& monitor)
{
  assert(std::int64_t(plane.size()) == mesh.NumberOfPoints());
  RawVector<PointId> triangles = CloseFaults(plane, boundary, ReadCracks(mesh, boundary), monitor);
  const std::size_t size = triangles.size() / 3;
  DataArray marks = NewArray<unsigned char>(CellArray::Fault, mesh.NumberOfCells() + std::int64_t(size));
  auto* const ofFaults = std::fill_n(marks.As<unsigned char>(), mesh.NumberOfCells(), static_cast<unsigned char>(0));
  std::fill_n(ofFaults, size, static_cast<unsigned char>(1));
  ExtendCellData(MeasureQuality(plane, triangles), size, mesh.CellData);
  mesh.CellData.Add(std::move(marks));
  FaceUp(lattice, triangles);
  mesh.Polygons = mesh.Polygons.Offsets.Type() == ValueType::Int
    ? AppendTriangles<int>(mesh.Polygons, triangles)
    : AppendTriangles<std::int64_t>(mesh.Polygons, triangles);
  AddValue<std::int64_t>(mesh.FieldData, FieldArray::FaultTriangleCount, std::int64_t(size));
}
}
