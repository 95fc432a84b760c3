// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CrackData.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/VTK/DataArrays.h"
#include "FaultClosing/FaultClosing.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "Triangulation/TriangleQuality.h"

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
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int MouthComponents = 4; // the columns of both ends

bool HasCuts(vtkFieldData* data)
{
  vtkDataArray* const links = FindNumbers(data, FieldArray::CutLinks);
  return links && links->GetNumberOfTuples() > 0;
}

std::array<int, 2> ColumnOf(vtkPolyData* horizon, const Lattice& grid, PointId point)
{
  Eigen::Vector3d world;
  horizon->GetPoint(point, world.data());
  const Eigen::Vector3d place = grid.ToLattice(world);
  return { int(std::lround(place.x())), int(std::lround(place.y())) };
}

/// A whole number, at least 0, of an array.
int ReadNumber(vtkDataArray* array, vtkIdType tuple, int component)
{
  const double value = array->GetComponent(tuple, component);
  if (!(value >= 0.0 && value <= MostColumnsPerSide && value == std::floor(value)))
  {
    throw InputError(std::string(array->GetName()) + " " + std::to_string(value) + " in tuple " +
      std::to_string(tuple) + ", expected a whole number, at least 0");
  }
  return int(value);
}

/// An array of the field data with so many components; null where there is none.
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

/// Mouths by the columns of their ends.
std::vector<std::array<PlanePoint, 2>> ReadMouths(vtkFieldData* data)
{
  std::vector<std::array<PlanePoint, 2>> mouths;
  vtkDataArray* const array = FindTuples(data, FieldArray::CutMouths, MouthComponents);
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
  {
    const auto read = [&](int component) { return ReadNumber(array, n, component); };
    mouths.push_back({ PlanePoint{ read(0), read(1) }, PlanePoint{ read(2), read(3) } });
  }
  return mouths;
}

/// The points of loops in columns that mouths end in, by columns.
class MouthPoints
{
public:
  MouthPoints(const std::vector<std::array<PlanePoint, 2>>& mouths, const std::vector<PlanePoint>& plane,
    std::int32_t columnSize, const Loops& boundary)
  {
    for (const std::array<PlanePoint, 2>& mouth : mouths)
    {
      this->Columns.insert(this->Columns.end(), mouth.begin(), mouth.end());
    }
    std::sort(this->Columns.begin(), this->Columns.end());
    this->Points.assign(this->Columns.size(), NoPoint);
    boundary.ForEachPoint(
      [&](PointId point)
      {
        const PlanePoint& place = plane[std::size_t(point)];
        const PlanePoint column{ place.X / columnSize, place.Y / columnSize };
        const std::size_t slot = this->SlotOf(column);
        if (slot < this->Columns.size() && place == PlanePoint{ column.X * columnSize, column.Y * columnSize })
        {
          this->Points[slot] = point;
        }
      });
  }

  PointId At(const PlanePoint& column) const
  {
    const PointId point = this->Points[this->SlotOf(column)];
    if (point == NoPoint)
    {
      throw InputError("a mouth of a crack at column (" + std::to_string(column.X) + ", " + std::to_string(column.Y) +
        "), expected a point of a boundary loop: simplify the boundary with the field data array " +
        FieldArray::CutMouths);
    }
    return point;
  }

private:
  std::size_t SlotOf(const PlanePoint& column) const
  {
    const auto found = std::lower_bound(this->Columns.begin(), this->Columns.end(), column);
    return found != this->Columns.end() && *found == column ? std::size_t(found - this->Columns.begin())
                                                            : this->Columns.size();
  }

  std::vector<PlanePoint> Columns; // the first of equal ones has a point
  std::vector<PointId> Points;
};

/// Adds the values of new triangles to the cell data of a mesh that has no cells of them yet: nan unless they are known.
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
  if (!HasCuts(data))
  {
    data->RemoveArray(FieldArray::CutMouths);
    data->RemoveArray(FieldArray::CrackLoops);
    return;
  }
  const Lattice grid = ReadLattice(horizon);
  auto mouths = NewArray<vtkIntArray>(FieldArray::CutMouths, vtkIdType(cracks.Mouths.size()), MouthComponents);
  for (std::size_t n = 0; n < cracks.Mouths.size(); ++n)
  {
    const std::array<int, 2> from = ColumnOf(horizon, grid, cracks.Mouths[n].From);
    const std::array<int, 2> to = ColumnOf(horizon, grid, cracks.Mouths[n].To);
    const std::array<int, MouthComponents> tuple = { from[0], from[1], to[0], to[1] };
    mouths->SetTypedTuple(vtkIdType(n), tuple.data());
  }
  data->AddArray(mouths);
  AddArray<vtkIdTypeArray>(data, FieldArray::CrackLoops, cracks.Loops);
}

//----------------------------------------------------------------------------------------------------------------------
Cracks ReadCracks(
  vtkPolyData* horizon, const std::vector<PlanePoint>& plane, const Lattice& grid, const Loops& boundary)
{
  Cracks cracks;
  const std::vector<std::array<PlanePoint, 2>> mouths = ReadMouths(horizon->GetFieldData());
  if (!mouths.empty())
  {
    const MouthPoints points(mouths, plane, grid.SubVoxelsPerColumn(), boundary);
    for (const std::array<PlanePoint, 2>& mouth : mouths)
    {
      cracks.Mouths.push_back({ points.At(mouth[0]), points.At(mouth[1]) });
    }
  }
  vtkDataArray* const loops = FindTuples(horizon->GetFieldData(), FieldArray::CrackLoops, 1);
  for (vtkIdType n = 0; loops && n < loops->GetNumberOfTuples(); ++n)
  {
    cracks.Loops.push_back(std::size_t(ReadNumber(loops, n, 0)));
  }
  return cracks;
}

//----------------------------------------------------------------------------------------------------------------------
void CloseMesh(const std::vector<PlanePoint>& plane, const Lattice& grid, const Loops& boundary, vtkPolyData* mesh,
  const Monitor& monitor)
{
  RawVector<PointId> triangles = CloseFaults(plane, boundary, ReadCracks(mesh, plane, grid, boundary), monitor);
  const std::size_t size = triangles.size() / 3;
  auto marks = NewArray<vtkUnsignedCharArray>(CellArray::Fault, mesh->GetNumberOfCells() + vtkIdType(size));
  std::fill_n(marks->GetPointer(0), mesh->GetNumberOfCells(), static_cast<unsigned char>(0));
  std::fill_n(marks->GetPointer(mesh->GetNumberOfCells()), size, static_cast<unsigned char>(1));
  ExtendCellData(MeasureQuality(plane, triangles), size, mesh->GetCellData());
  mesh->GetCellData()->AddArray(marks);
  FaceUp(grid, triangles);
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    const std::array<vtkIdType, 3> corners = { triangles[corner], triangles[corner + 1], triangles[corner + 2] };
    mesh->GetPolys()->InsertNextCell(3, corners.data());
  }
  AddValue<vtkIdTypeArray>(mesh->GetFieldData(), FieldArray::FaultTriangleCount, vtkIdType(size));
}
}
