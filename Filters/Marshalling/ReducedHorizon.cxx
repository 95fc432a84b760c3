// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReducedHorizon.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/MergedPoints.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/VertexCells.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
template <typename InputArray, typename OutputArray>
void WriteMeans(const MergedPoints& points, InputArray* input, OutputArray* output)
{
  using Value = vtk::GetAPIType<OutputArray>;
  const auto from = vtk::DataArrayTupleRange(input);
  auto to = vtk::DataArrayTupleRange(output);
  const int components = input->GetNumberOfComponents();
  ParallelFor(points.Size(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType target = first; target < last; ++target)
      {
        for (int n = 0; n < components; ++n)
        {
          to[target][n] =
            static_cast<Value>(points.Average(target, [&](PointId point) { return double(from[point][n]); }));
        }
      }
    });
}

bool IsAveraged(vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ||
    (array->GetName() && !std::strcmp(array->GetName(), PointArray::VerticalIndex));
}

/// Means of float arrays are float, and double otherwise.
vtkSmartPointer<vtkDataArray> Average(vtkDataArray* array, const MergedPoints& points)
{
  vtkSmartPointer<vtkDataArray> result;
  result.TakeReference(
    array->GetDataType() == VTK_FLOAT ? static_cast<vtkDataArray*>(vtkFloatArray::New()) : vtkDoubleArray::New());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->CopyComponentNames(array);
  SetNumberOfTuples(result, points.Size());
  const auto write = [&](auto* output)
  {
    const auto read = [&](auto* input) { WriteMeans(points, input, output); };
    if (!vtkArrayDispatch::Dispatch::Execute(array, read))
    {
      read(array);
    }
  };
  if (auto* const floats = vtkFloatArray::FastDownCast(result))
  {
    write(floats);
  }
  else
  {
    write(vtkDoubleArray::FastDownCast(result));
  }
  return result;
}

void ReduceAttributes(
  vtkPolyData* input, const std::vector<PointId>& sources, const MergedPoints& points, vtkPolyData* output)
{
  KeptPoints nearest(std::size_t(input->GetNumberOfPoints()));
  std::for_each(sources.begin(), sources.end(), [&nearest](PointId point) { nearest.Append(point); });
  for (int n = 0; n < input->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = input->GetPointData()->GetAbstractArray(n);
    vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
    const vtkSmartPointer<vtkAbstractArray> reduced =
      numbers && IsAveraged(numbers) ? Average(numbers, points).Get() : CopyTuples(array, nearest).Get();
    AddPointArray(input, n, reduced, output);
  }
}

/// Merged points leave their columns, unless only heights were merged.
void WriteColumns(const Reduction& reduction, vtkPolyData* output)
{
  int* const columns = vtkIntArray::SafeDownCast(output->GetPointData()->GetArray(PointArray::Column))->GetPointer(0);
  for (std::size_t point = 0; point < reduction.Averaged.size(); ++point)
  {
    if (reduction.Averaged[point] != 0 && reduction.SubVoxelsPerColumn > 1)
    {
      columns[2 * point] = NoColumn.X;
      columns[2 * point + 1] = NoColumn.Y;
    }
  }
}

/// Simplified loops may have left points inside.
void UnmarkInside(const Loops& boundary, vtkPolyData* output)
{
  vtkDataArray* const marks = output->GetPointData()->GetArray(PointArray::Boundary);
  if (!marks)
  {
    return;
  }
  auto* const bytes = vtkUnsignedCharArray::FastDownCast(marks); // This is the type of our own marks.
  const unsigned char* const values = bytes ? bytes->GetPointer(0) : nullptr;
  const auto isMarked = [&](vtkIdType point)
  { return values ? values[point] != 0 : marks->GetComponent(point, 0) != 0.0; };
  const std::vector<unsigned char> isOnLoop = boundary.MarkPoints(std::size_t(output->GetNumberOfPoints()));
  vtkSmartPointer<vtkDataArray> changed; // The input may share the array.
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    if (isMarked(point) && isOnLoop[point] == 0)
    {
      if (!changed)
      {
        changed.TakeReference(marks->NewInstance());
        changed->DeepCopy(marks);
      }
      changed->SetComponent(point, 0, double(BoundaryKind::Inside));
    }
  }
  if (changed)
  {
    output->GetPointData()->AddArray(changed);
  }
}

/// Counts of dropped points are added to their targets.
vtkSmartPointer<vtkIdTypeArray> AddDropped(
  const std::vector<std::int64_t>& counts, const KeptPoints& kept, const DroppedPoints& dropped)
{
  auto sums = NewArray<vtkIdTypeArray>(PointArray::PointCount, vtkIdType(kept.size()));
  vtkIdType* const values = sums->GetPointer(0);
  kept.ForEachRun(0, kept.size(),
    [&](std::size_t n, PointId point, std::size_t length)
    {
      for (std::size_t next = 0; next < length; ++next)
      {
        values[n + next] = counts.empty() ? 1 : counts[std::size_t(point) + next];
      }
    });
  for (const DroppedPoint& one : dropped)
  {
    values[NumberWithout(dropped, one.Target)] += counts.empty() ? 1 : counts[one.Point];
  }
  return sums;
}

vtkSmartPointer<vtkIdTypeArray> SumCounts(const MergedPoints& points)
{
  auto sums = NewArray<vtkIdTypeArray>(PointArray::PointCount, points.Size());
  vtkIdType* const values = sums->GetPointer(0);
  ParallelFor(points.Size(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType target = first; target < last; ++target)
      {
        values[target] = points.SumCounts(target);
      }
    });
  return sums;
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkIntArray> NewOriginArray(vtkIdType size)
{
  auto array = NewArray<vtkIntArray>(PointArray::CellOrigin, size, 3);
  array->SetComponentName(0, "Level");
  array->SetComponentName(1, "Ring");
  array->SetComponentName(2, "Kind");
  return array;
}

//----------------------------------------------------------------------------------------------------------------------
void SetOrigin(vtkIntArray* array, vtkIdType n, const PointOrigin& origin)
{
  assert(n < array->GetNumberOfTuples());
  const int values[3] = { origin.Level, origin.Ring, int(origin.Kind) };
  array->SetTypedTuple(n, values);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> MakePoints(vtkPolyData* input, const Lattice& lattice, const Reduction& reduction)
{
  assert(reduction.Plane.size() == reduction.Source.size() && reduction.Averaged.size() == reduction.Source.size());
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  SetNumberOfTuples(places, vtkIdType(reduction.Source.size()));
  double* const values = places->GetPointer(0);
  ParallelFor(places->GetNumberOfTuples(), Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType n = first; n < last; ++n)
      {
        const Eigen::Vector3d world = WorldPlace(reduction, std::size_t(n), lattice,
          [input](PointId source)
          {
            Eigen::Vector3d place;
            input->GetPoint(source, place.data());
            return place;
          });
        std::copy_n(world.data(), 3, values + 3 * n);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(places);
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReduction(vtkPolyData* input, const Reduction& reduction, vtkPolyData* output)
{
  assert(output->GetNumberOfPoints() == vtkIdType(reduction.Source.size()));
  assert(input->GetNumberOfPoints() == vtkIdType(reduction.Target.size()));
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  output->SetLines(MakePolylines(reduction.Boundary));
  vtkPointData* const data = output->GetPointData();
  const MergedPoints points(reduction, ReadCounts(input));
  ReduceAttributes(input, reduction.Source, points, output);
  UnmarkInside(reduction.Boundary, output);
  WriteColumns(reduction, output);
  if (input->GetPointData()->HasArray(PointArray::PointCount) ||
    output->GetNumberOfPoints() < input->GetNumberOfPoints())
  {
    data->AddArray(SumCounts(points));
  }
  if (!reduction.Origin.empty())
  {
    vtkSmartPointer<vtkIntArray> origins = NewOriginArray(output->GetNumberOfPoints());
    for (std::size_t point = 0; point < reduction.Origin.size(); ++point)
    {
      SetOrigin(origins, vtkIdType(point), reduction.Origin[point]);
    }
    data->AddArray(origins);
  }
  if (!reduction.Flatness.empty())
  {
    AddArray<vtkDoubleArray>(data, PointArray::Flatness, reduction.Flatness);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDropped(vtkPolyData* input, const DroppedPoints& dropped, const Loops& boundary, vtkPolyData* output)
{
  const KeptPoints kept = KeepOthers(dropped, std::size_t(input->GetNumberOfPoints()));
  CopyPoints(input, kept, output);
  const Loops loops = RenumberWithout(dropped, boundary);
  output->SetLines(MakePolylines(loops));
  UnmarkInside(loops, output);
  if (!dropped.empty())
  {
    output->GetPointData()->AddArray(AddDropped(ReadCounts(input), kept, dropped));
  }
}
}
