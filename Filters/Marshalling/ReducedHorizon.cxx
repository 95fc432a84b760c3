// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReducedHorizon.h"

#include "Common/DataModel.h"
#include "Common/Parallel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/VertexCells.h"
#include "HorizonCells.h"
#include "HorizonData.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 16384; // points that a thread takes at a time

/// Copies the values of the input point that each output point is, or that is nearest to it.
struct GatherWorker
{
  const std::vector<PointId>& Sources;

  template <typename InputArray, typename OutputArray>
  void operator()(InputArray* input, OutputArray* output) const
  {
    using Value = vtk::GetAPIType<OutputArray>;
    const auto from = vtk::DataArrayTupleRange(input);
    auto to = vtk::DataArrayTupleRange(output);
    const int components = input->GetNumberOfComponents();
    ParallelFor(std::int64_t(this->Sources.size()), Grain,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType point = first; point < last; ++point)
        {
          for (int n = 0; n < components; ++n)
          {
            to[point][n] = static_cast<Value>(from[this->Sources[std::size_t(point)]][n]);
          }
        }
      });
  }
};

/// False for arrays that are not of numbers, or of rare kinds.
bool Gather(const std::vector<PointId>& sources, vtkDataArray* input, vtkDataArray* output)
{
  const GatherWorker gather{ sources };
  if (auto* const doubles = vtkDoubleArray::FastDownCast(output))
  {
    return input && vtkArrayDispatch::Dispatch::Execute(input, [&](auto* typed) { gather(typed, doubles); });
  }
  return input && output && vtkArrayDispatch::Dispatch2SameValueType::Execute(input, output, gather);
}

/// How much each input point weighs in the mean of the output point it is merged into: its count. Where all counts are
/// 0, as those of points that were filled in, all weigh the same.
std::vector<double> FindWeights(const Reduction& reduction, const std::vector<std::int64_t>& counts)
{
  std::vector<std::int64_t> totals(reduction.Source.size(), 0);
  for (std::size_t point = 0; point < counts.size(); ++point)
  {
    totals[std::size_t(reduction.Target[point])] += counts[point];
  }
  std::vector<double> weights(counts.size());
  for (std::size_t point = 0; point < counts.size(); ++point)
  {
    weights[point] = totals[std::size_t(reduction.Target[point])] == 0 ? 1.0 : double(counts[point]);
  }
  return weights;
}

/// Writes the means of the values at averaged points. Values that are not finite do not count; where there are no
/// others, the one of the nearest point stays.
struct AverageWorker
{
  const Reduction& Merged;
  const std::vector<double>& Weights;
  vtkDataArray* Output;

  template <typename Array>
  void operator()(Array* input) const
  {
    const int components = input->GetNumberOfComponents();
    const auto tuples = vtk::DataArrayTupleRange(input);
    const std::size_t size = this->Merged.Source.size();
    std::vector<double> sums(size);
    std::vector<double> weights(size);
    for (int n = 0; n < components; ++n)
    {
      std::fill(sums.begin(), sums.end(), 0.0);
      std::fill(weights.begin(), weights.end(), 0.0);
      for (std::size_t point = 0; point < this->Merged.Target.size(); ++point)
      {
        const std::size_t target = std::size_t(this->Merged.Target[point]);
        const double value = double(tuples[vtkIdType(point)][n]);
        if (this->Merged.Averaged[target] && std::isfinite(value))
        {
          sums[target] += this->Weights[point] * value;
          weights[target] += this->Weights[point];
        }
      }
      this->WriteMeans(sums, weights, n);
    }
  }

  void WriteMeans(const std::vector<double>& sums, const std::vector<double>& weights, int component) const
  {
    for (std::size_t target = 0; target < weights.size(); ++target)
    {
      if (weights[target] > 0.0)
      {
        this->Output->SetComponent(vtkIdType(target), component, sums[target] / weights[target]);
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
  result->CopyComponentNames(array);
  return result;
}

void GetTuples(const std::vector<PointId>& sources, vtkAbstractArray* input, vtkAbstractArray* output)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(vtkIdType(sources.size()));
  std::copy(sources.begin(), sources.end(), ids->begin());
  input->GetTuples(ids, output);
}

void ReduceAttributes(vtkPolyData* input, const Reduction& reduction, const std::vector<std::int64_t>& counts,
  Merging merging, vtkPolyData* output)
{
  const std::vector<double> weights = FindWeights(reduction, counts);
  for (int n = 0; n < input->GetPointData()->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* const array = input->GetPointData()->GetAbstractArray(n);
    vtkSmartPointer<vtkAbstractArray> reduced = NewArrayLike(array, merging);
    reduced->SetNumberOfTuples(vtkIdType(reduction.Source.size()));
    vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
    vtkDataArray* const reducedNumbers = vtkDataArray::SafeDownCast(reduced);
    if (!Gather(reduction.Source, numbers, reducedNumbers))
    {
      GetTuples(reduction.Source, array, reduced);
    }
    if (merging == Merging::AveragesPoints && numbers && IsAveraged(numbers))
    {
      const AverageWorker average{ reduction, weights, reducedNumbers };
      if (!vtkArrayDispatch::Dispatch::Execute(numbers, average))
      {
        average(numbers);
      }
    }
    const int index = output->GetPointData()->AddArray(reduced);
    const int attribute = input->GetPointData()->IsArrayAnAttribute(n);
    if (attribute >= 0)
    {
      output->GetPointData()->SetActiveAttribute(index, attribute);
    }
  }
}

void SumCounts(const Reduction& reduction, const std::vector<std::int64_t>& counts, vtkPolyData* output)
{
  auto sums = NewArray<vtkIdTypeArray>(PointArray::PointCount, vtkIdType(reduction.Source.size()));
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
  const int values[3] = { origin.Level, origin.Ring, int(origin.Kind) };
  array->SetTypedTuple(n, values);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> MakePoints(vtkPolyData* input, const Lattice& grid, const Reduction& reduction)
{
  vtkNew<vtkDoubleArray> places;
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(vtkIdType(reduction.Source.size()));
  double* const values = places->GetPointer(0);
  ParallelFor(places->GetNumberOfTuples(), Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType n = first; n < last; ++n)
      {
        const std::size_t point = std::size_t(n);
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
        std::copy_n(world.data(), 3, values + 3 * n);
      }
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(places);
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReduction(
  vtkPolyData* input, const Lattice& grid, const Reduction& reduction, Merging merging, vtkPolyData* output)
{
  output->SetPoints(MakePoints(input, grid, reduction));
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  output->SetLines(MakePolylines(reduction.Boundary));
  const std::vector<std::int64_t> counts = ReadCounts(input);
  ReduceAttributes(input, reduction, counts, merging, output);
  SumCounts(reduction, counts, output);
  if (!reduction.Origin.empty())
  {
    vtkSmartPointer<vtkIntArray> origins = NewOriginArray(output->GetNumberOfPoints());
    for (std::size_t point = 0; point < reduction.Origin.size(); ++point)
    {
      SetOrigin(origins, vtkIdType(point), reduction.Origin[point]);
    }
    output->GetPointData()->AddArray(origins);
  }
  if (!reduction.Flatness.empty())
  {
    AddArray<vtkDoubleArray>(output->GetPointData(), PointArray::Flatness, reduction.Flatness);
  }
}
}
