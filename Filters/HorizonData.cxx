// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonData.h"

#include "DataModel.h"
#include "Errors.h"
#include "Parallel.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
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

vtkSmartPointer<vtkCellArray> MakeCells(vtkTypeInt32Array* offsets, vtkTypeInt32Array* points)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}

/// Adds the values of the averaged points of an array to their sums and writes the means.
struct AverageWorker
{
  const Reduction& Merged;
  const std::vector<std::int64_t>& Counts;
  vtkDataArray* Output;

  template <typename Array>
  void operator()(Array* input) const
  {
    const int components = input->GetNumberOfComponents();
    const auto tuples = vtk::DataArrayTupleRange(input);
    std::vector<double> sums(this->Merged.Source.size() * std::size_t(components), 0.0);
    std::vector<double> weights(this->Merged.Source.size(), 0.0);
    for (std::size_t point = 0; point < this->Merged.Target.size(); ++point)
    {
      const std::size_t target = std::size_t(this->Merged.Target[point]);
      if (!this->Merged.Averaged[target])
      {
        continue;
      }
      const double weight = double(this->Counts[point]);
      weights[target] += weight;
      for (int n = 0; n < components; ++n)
      {
        sums[target * std::size_t(components) + std::size_t(n)] += weight * double(tuples[vtkIdType(point)][n]);
      }
    }
    this->WriteMeans(sums, weights, components);
  }

  void WriteMeans(const std::vector<double>& sums, const std::vector<double>& weights, int components) const
  {
    for (std::size_t target = 0; target < weights.size(); ++target)
    {
      for (int n = 0; this->Merged.Averaged[target] && n < components; ++n)
      {
        this->Output->SetComponent(
          vtkIdType(target), n, sums[target * std::size_t(components) + std::size_t(n)] / weights[target]);
      }
    }
  }
};

bool IsAveraged(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ||
    (array->GetName() && !std::strcmp(array->GetName(), PointArray::VerticalIndex));
}

vtkSmartPointer<vtkAbstractArray> NewArrayLike(vtkAbstractArray* array, Merging merging)
{
  vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
  vtkSmartPointer<vtkAbstractArray> result;
  if (merging == Merging::AveragesPoints && numbers && IsAveraged(numbers) && numbers->GetDataType() != VTK_FLOAT)
  {
    result = vtkSmartPointer<vtkDoubleArray>::New();
  }
  else
  {
    result.TakeReference(array->NewInstance());
  }
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  return result;
}

void ReduceAttributes(vtkPolyData* input, const Reduction& reduction, Merging merging, vtkPolyData* output)
{
  vtkNew<vtkIdList> sources;
  sources->SetNumberOfIds(vtkIdType(reduction.Source.size()));
  std::copy(reduction.Source.begin(), reduction.Source.end(), sources->begin());
  const std::vector<std::int64_t> counts = ReadCounts(input);
  for (int n = 0; n < input->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = input->GetPointData()->GetAbstractArray(n);
    vtkSmartPointer<vtkAbstractArray> reduced = NewArrayLike(array, merging);
    reduced->SetNumberOfTuples(sources->GetNumberOfIds());
    array->GetTuples(sources, reduced);
    vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
    if (merging == Merging::AveragesPoints && numbers && IsAveraged(numbers))
    {
      const AverageWorker average{ reduction, counts, vtkDataArray::SafeDownCast(reduced) };
      if (!vtkArrayDispatch::Dispatch::Execute(numbers, average))
      {
        average(numbers);
      }
    }
    output->GetPointData()->AddArray(reduced);
  }
}

void SumCounts(vtkPolyData* input, const Reduction& reduction, vtkPolyData* output)
{
  const std::vector<std::int64_t> counts = ReadCounts(input);
  vtkNew<vtkIdTypeArray> sums;
  sums->SetName(PointArray::PointCount);
  sums->SetNumberOfValues(vtkIdType(reduction.Source.size()));
  sums->FillValue(0);
  for (std::size_t point = 0; point < counts.size(); ++point)
  {
    vtkIdType& sum = *sums->GetPointer(reduction.Target[point]);
    sum += counts[point];
  }
  output->GetPointData()->AddArray(sums);
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
  ParallelFor(size, 16384,
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
BoundedHorizon ReadBoundedHorizon(vtkPolyData* horizon, LatticePoints points)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = points.Grid.SubVoxelsPerColumn();
  result.Plane = std::move(points.Plane);
  result.Height = std::move(points.Height);
  result.Patch = ReadPatches(horizon);
  result.Count = ReadCounts(horizon);
  result.Boundary = ReadBoundary(horizon);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakeVertices(vtkIdType points)
{
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> ids;
  offsets->SetNumberOfValues(points + 1);
  ids->SetNumberOfValues(points);
  std::iota(offsets->Begin(), offsets->End(), 0);
  std::iota(ids->Begin(), ids->End(), 0);
  return MakeCells(offsets, ids);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakePolylines(const Loops& loops)
{
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> ids;
  offsets->InsertNextValue(0);
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    std::for_each(loops.begin(loop), loops.end(loop), [&ids](PointId point) { ids->InsertNextValue(point); });
    ids->InsertNextValue(*loops.begin(loop));
    offsets->InsertNextValue(std::int32_t(ids->GetNumberOfValues()));
  }
  return MakeCells(offsets, ids);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakeTriangles(const RawVector<PointId>& triangles)
{
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> ids;
  offsets->SetNumberOfValues(vtkIdType(triangles.size() / 3) + 1);
  for (vtkIdType triangle = 0; triangle < offsets->GetNumberOfValues(); ++triangle)
  {
    offsets->SetValue(triangle, std::int32_t(3 * triangle));
  }
  ids->SetNumberOfValues(vtkIdType(triangles.size()));
  std::copy(triangles.begin(), triangles.end(), ids->Begin());
  return MakeCells(offsets, ids);
}

//----------------------------------------------------------------------------------------------------------------------
void FaceUp(const Lattice& grid, RawVector<PointId>& triangles)
{
  for (std::size_t corner = 0; !grid.KeepsOrientation() && corner < triangles.size(); corner += 3)
  {
    std::swap(triangles[corner + 1], triangles[corner + 2]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(PointArray::CellOrigin);
  array->SetNumberOfComponents(3);
  array->SetComponentName(0, "Level");
  array->SetComponentName(1, "Ring");
  array->SetComponentName(2, "Kind");
  array->SetNumberOfTuples(size);
  return array;
}

//----------------------------------------------------------------------------------------------------------------------
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin)
{
  const int values[3] = { origin.Level, origin.Ring, int(origin.Kind) };
  array->SetTypedTuple(n, values);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReduction(
  vtkPolyData* input, const Lattice& grid, const Reduction& reduction, Merging merging, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vtkIdType(reduction.Source.size()));
  for (std::size_t point = 0; point < reduction.Source.size(); ++point)
  {
    const PlanePoint& place = reduction.Plane[point];
    // A point that is still itself keeps its place to the last bit.
    Eigen::Vector3d world;
    if (reduction.Averaged[point])
    {
      world = grid.ToWorld({ grid.ToLatticeUnits(place.X), grid.ToLatticeUnits(place.Y), reduction.Height[point] });
    }
    else
    {
      input->GetPoint(reduction.Source[point], world.data());
    }
    points->SetPoint(vtkIdType(point), world.data());
  }
  output->SetPoints(points);
  output->SetVerts(MakeVertices(points->GetNumberOfPoints()));
  output->SetLines(MakePolylines(reduction.Boundary));
  ReduceAttributes(input, reduction, merging, output);
  SumCounts(input, reduction, output);
  if (!reduction.Origin.empty())
  {
    vtkSmartPointer<vtkIntArray> origins = NewOriginArray(points->GetNumberOfPoints());
    for (std::size_t point = 0; point < reduction.Origin.size(); ++point)
    {
      SetOrigin(origins, vtkIdType(point), reduction.Origin[point]);
    }
    output->GetPointData()->AddArray(origins);
  }
}
}
