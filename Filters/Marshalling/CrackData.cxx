// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CrackData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "CutData.h"
#include "Filters/Algorithms/FaultClosing/FaultClosing.h"
#include "Filters/Algorithms/Triangulation/TriangleQuality.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "LatticePoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

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

bool HasCuts(vtkFieldData* data)
{
  vtkDataArray* const links = FindFaultedLinks(data);
  return links && links->GetNumberOfTuples() > 0;
}

/// Throws InputError unless the value is a whole number of at least 0.
int ReadLinkNumber(vtkDataArray* array, vtkIdType tuple, int component)
{
  const double value = array->GetComponent(tuple, component);
  if (!(value >= 0.0 && value <= MostColumnsPerSide && value == std::floor(value)))
  {
    std::ostringstream text;
    text << array->GetName() << ' ' << value << " in tuple " << tuple << ", expected a whole number, at least 0";
    throw InputError(text.str());
  }
  return int(value);
}

/// Returns null without the array, and throws InputError on another number of components.
vtkDataArray* FindTuples(vtkFieldData* data, const char* name, int components)
{
  vtkDataArray* const array = FindNumbers(data, name);
  if (array && array->GetNumberOfComponents() != components)
  {
    throw InputError("field data array " + std::string(name) + " with " +
      std::to_string(array->GetNumberOfComponents()) + " components, expected " + std::to_string(components));
  }
  return array;
}

/// Version 0.2 used another name.
std::vector<std::array<PlanePoint, 2>> ReadOpenEnds(vtkFieldData* data)
{
  std::vector<std::array<PlanePoint, 2>> openEnds;
  const char* const name =
    data->HasArray(FieldArray::CrackOpenEnds) ? FieldArray::CrackOpenEnds : FieldArray::OldCrackOpenEnds;
  vtkDataArray* const array = FindTuples(data, name, OpenEndComponents);
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
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
void CheckNumberOfLoops(vtkFieldData* data, const Loops& boundary)
{
  vtkDataArray* const patches = FindTuples(data, FieldArray::NumberOfPatches, 1);
  vtkDataArray* const holes = FindTuples(data, FieldArray::NumberOfHoles, 1);
  if (!patches || !holes || FieldValue(patches, 0) + FieldValue(holes, 0) != double(boundary.Size()))
  {
    throw InputError(std::to_string(boundary.Size()) + " boundary loops with the field data array " +
      FieldArray::CrackLoops + ", expected as many as " + FieldArray::NumberOfPatches + " and " +
      FieldArray::NumberOfHoles + " say: close faults of whole horizons");
  }
}

Cracks ReadCracks(vtkPolyData* horizon, const Loops& boundary)
{
  Cracks cracks;
  const std::vector<std::array<PlanePoint, 2>> openEnds = ReadOpenEnds(horizon->GetFieldData());
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
  vtkDataArray* const loops = FindTuples(horizon->GetFieldData(), FieldArray::CrackLoops, 1);
  for (vtkIdType n = 0; loops && n < loops->GetNumberOfTuples(); ++n)
  {
    cracks.Loops.push_back(std::size_t(ReadLinkNumber(loops, n, 0)));
  }
  if (!cracks.Loops.empty())
  {
    CheckNumberOfLoops(horizon->GetFieldData(), boundary);
  }
  return cracks;
}

/// New triangles have nan in all other arrays.
void ExtendCellData(const TriangleQuality& quality, std::size_t triangles, vtkCellData* data)
{
  const std::vector<std::pair<const char*, const RawVector<float>*>> known = {
    { CellArray::Compactness, &quality.Compactness }, { CellArray::Quality, &quality.Shape }
  };
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const array = data->GetArray(n);
    const auto found = std::find_if(
      known.begin(), known.end(), [array](const auto& named) { return !std::strcmp(named.first, array->GetName()); });
    for (std::size_t triangle = 0; triangle < triangles; ++triangle)
    {
      array->InsertNextTuple1(
        found == known.end() ? std::numeric_limits<double>::quiet_NaN() : double((*found->second)[triangle]));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteCracks(const Cracks& cracks, vtkPolyData* horizon)
{
  vtkFieldData* const data = horizon->GetFieldData();
  data->RemoveArray(FieldArray::OldCrackOpenEnds);
  if (!HasCuts(data))
  {
    data->RemoveArray(FieldArray::CrackOpenEnds);
    data->RemoveArray(FieldArray::CrackLoops);
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
  auto openEnds = NewArray<vtkIntArray>(FieldArray::CrackOpenEnds, vtkIdType(tuples.size()), OpenEndComponents);
  for (std::size_t n = 0; n < tuples.size(); ++n)
  {
    openEnds->SetTypedTuple(vtkIdType(n), tuples[n].data());
  }
  data->AddArray(openEnds);
  AddArray<vtkIdTypeArray>(data, FieldArray::CrackLoops, cracks.Loops);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> ReadPointsOfOpenEnds(vtkPolyData* horizon, PlanePoints columns, const Loops& boundary)
{
  const std::vector<std::array<PlanePoint, 2>> openEnds = ReadOpenEnds(horizon->GetFieldData());
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
void CloseMesh(const std::vector<PlanePoint>& plane, const Lattice& lattice, const Loops& boundary, vtkPolyData* mesh,
  const Monitor& monitor)
{
  assert(vtkIdType(plane.size()) == mesh->GetNumberOfPoints());
  RawVector<PointId> triangles = CloseFaults(plane, boundary, ReadCracks(mesh, boundary), monitor);
  const std::size_t size = triangles.size() / 3;
  auto marks = NewArray<vtkUnsignedCharArray>(CellArray::Fault, mesh->GetNumberOfCells() + vtkIdType(size));
  std::fill_n(marks->GetPointer(0), mesh->GetNumberOfCells(), static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(mesh->GetNumberOfCells()), size, static_cast<unsigned char>(1));
  ExtendCellData(MeasureQuality(plane, triangles), size, mesh->GetCellData());
  mesh->GetCellData()->AddArray(marks);
  FaceUp(lattice, triangles);
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    const std::array<vtkIdType, 3> corners = { triangles[corner], triangles[corner + 1], triangles[corner + 2] };
    mesh->GetPolys()->InsertNextCell(3, corners.data());
  }
  AddValue<vtkIdTypeArray>(mesh->GetFieldData(), FieldArray::FaultTriangleCount, vtkIdType(size));
}
}
