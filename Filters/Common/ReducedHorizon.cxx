// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReducedHorizon.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/MergedPoints.h"
#include "HorizonCells.h"
#include "HorizonData.h"
#include "HorizonPoints.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
bool IsAveraged(const DataArray& array)
{
  return array.IsFloating() || (!array.IsText() && array.Name == PointArray::VerticalIndex);
}

/// meanOf(numbers, target, component) has the numbers of the array.
template <typename T, typename MeanOf>
DataArray AverageAs(const DataArray& array, std::int64_t size, MeanOf&& meanOf)
{
  const int components = array.Components();
  DataArray means = NewArray<T>(array.Name.c_str(), size, components);
  means.ComponentNames = array.ComponentNames;
  means.Role = array.Role;
  T* const to = means.As<T>();
  array.WithNumbers(
    [&](const auto* from)
    {
      ParallelFor(size, Grain,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first * components; n < last * components; ++n)
          {
            to[n] = static_cast<T>(meanOf(from, n / components, int(n % components)));
          }
        });
    });
  return means;
}

/// Means of float arrays are float, and double otherwise.
template <typename MeanOf>
DataArray Average(const DataArray& array, std::int64_t size, MeanOf&& meanOf)
{
  return array.Type() == ValueType::Float ? AverageAs<float>(array, size, meanOf)
                                          : AverageAs<double>(array, size, meanOf);
}

void ReduceAttributes(
  const Horizon& input, const std::vector<PointId>& sources, const MergedPoints& points, Horizon& output)
{
  KeptPoints nearest(std::size_t(input.NumberOfPoints()));
  std::for_each(sources.begin(), sources.end(), [&nearest](PointId point) { nearest.Append(point); });
  for (const DataArray& array : input.PointData)
  {
    const int components = array.Components();
    const auto meanOf = [&](const auto* numbers, std::int64_t target, int component)
    {
      return points.Average(
        target, [&](PointId point) { return double(numbers[std::int64_t(components) * point + component]); });
    };
    output.PointData.Add(IsAveraged(array) ? Average(array, points.Size(), meanOf) : array.Select(nearest));
  }
}

/// `nearest` has a point for each output point.
void ReduceAttributes(const Horizon& nearest, const MergedParts& merged, const Reduction& reduction, Horizon& output)
{
  for (const DataArray& array : nearest.PointData)
  {
    const std::vector<FiniteMean>* const means = merged.FindMeans(array.Name);
    const auto meanOf = [&](const auto* numbers, std::int64_t target, int component)
    {
      const std::int64_t n = target * array.Components() + component;
      const auto own = [&]() { return double(numbers[n]); };
      return reduction.Averaged[std::size_t(target)] != 0 ? (*means)[std::size_t(n)].Value(own) : own();
    };
    output.PointData.Add(means ? Average(array, nearest.NumberOfPoints(), meanOf) : array);
  }
}

/// Merged points leave their columns, unless only heights were merged.
void WriteColumns(const Reduction& reduction, Horizon& output)
{
  int* const columns = output.PointData.Find(PointArray::Column)->As<int>();
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
void UnmarkInside(const Loops& boundary, Horizon& output)
{
  const DataArray* const marks = FindNumbers(output.PointData, PointArray::Boundary);
  if (!marks)
  {
    return;
  }
  const std::vector<unsigned char> isOnLoop = boundary.MarkPoints(std::size_t(output.NumberOfPoints()));
  std::vector<std::int64_t> inside;
  marks->WithNumbers(
    [&](const auto* values)
    {
      for (std::int64_t point = 0; point < output.NumberOfPoints(); ++point)
      {
        if (values[point * marks->Components()] != 0 && isOnLoop[std::size_t(point)] == 0)
        {
          inside.push_back(point);
        }
      }
    });
  if (!inside.empty())
  {
    DataArray changed = marks->Select(KeptPoints::All(std::size_t(marks->Tuples()))); // The input may share the array.
    for (const std::int64_t point : inside)
    {
      changed.Set(point, 0, double(BoundaryKind::Inside));
    }
    output.PointData.Add(std::move(changed));
  }
}

/// Counts of dropped points are added to their targets.
DataArray AddDropped(const std::vector<std::int64_t>& counts, const KeptPoints& kept, const DroppedPoints& dropped)
{
  DataArray sums = NewArray<std::int64_t>(PointArray::PointCount, std::int64_t(kept.size()));
  auto* const values = sums.As<std::int64_t>();
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

template <typename CountOf>
void WriteCounts(std::int64_t size, CountOf&& countOf, Horizon& output)
{
  DataArray sums = NewArray<std::int64_t>(PointArray::PointCount, size);
  auto* const values = sums.As<std::int64_t>();
  ParallelFor(size, Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t target = first; target < last; ++target)
      {
        values[target] = countOf(target);
      }
    });
  output.PointData.Add(std::move(sums));
}

/// `output` has the arrays of the nearest points and means.
void AdaptToReduction(const Reduction& reduction, Horizon& output)
{
  output.Vertices = MakeVertices(output.NumberOfPoints());
  output.Lines = MakePolylines(reduction.Boundary);
  UnmarkInside(reduction.Boundary, output);
  WriteColumns(reduction, output);
}
}

//----------------------------------------------------------------------------------------------------------------------
DataArray MakePoints(const Horizon& input, const Lattice& lattice, const Reduction& reduction)
{
  assert(reduction.Plane.size() == reduction.Source.size() && reduction.Averaged.size() == reduction.Source.size());
  DataArray places = NewArray<double>("", std::int64_t(reduction.Source.size()), 3);
  auto* const values = places.As<double>();
  ParallelFor(places.Tuples(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const Eigen::Vector3d world =
          WorldPlace(reduction, std::size_t(n), lattice, [&input](PointId source) { return input.Place(source); });
        std::copy_n(world.data(), 3, values + 3 * n);
      }
    });
  return places;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReduction(const Horizon& input, const Reduction& reduction, Horizon& output)
{
  assert(output.NumberOfPoints() == std::int64_t(reduction.Source.size()));
  assert(input.NumberOfPoints() == std::int64_t(reduction.Target.size()));
  ArrayTable& data = output.PointData;
  const MergedPoints points(reduction, ReadCounts(input));
  ReduceAttributes(input, reduction.Source, points, output);
  AdaptToReduction(reduction, output);
  if (input.PointData.Has(PointArray::PointCount) || output.NumberOfPoints() < input.NumberOfPoints())
  {
    WriteCounts(
      points.Size(), [&points](std::int64_t target) { return points.SumCounts(target); }, output);
  }
  if (!reduction.Origin.empty())
  {
    data.Add(MakeOrigins(reduction.Origin, [](const PointOrigin& origin) -> const PointOrigin& { return origin; }));
  }
  if (!reduction.Flatness.empty())
  {
    AddArray<double>(data, PointArray::Flatness, reduction.Flatness);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteReduction(const Horizon& nearest, const MergedParts& merged, const Reduction& reduction, Horizon& output)
{
  assert(output.NumberOfPoints() == nearest.NumberOfPoints() && reduction.Origin.empty() && reduction.Flatness.empty());
  ReduceAttributes(nearest, merged, reduction, output);
  AdaptToReduction(reduction, output);
  if (output.NumberOfPoints() < merged.NumberOfPoints())
  {
    WriteCounts(
      output.NumberOfPoints(), [&merged](std::int64_t target) { return merged.CountOf(target); }, output);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MergedParts::Add(const ArrayTable& points, const PointId* targets, std::int64_t size)
{
  const auto addAll = [&](int components, auto& values, auto&& add)
  {
    for (std::int64_t point = 0; point < size; ++point)
    {
      if (targets[point] != NoPoint)
      {
        const std::size_t first = std::size_t(targets[point]) * std::size_t(components);
        if (first + std::size_t(components) > values.size())
        {
          values.resize(first + std::size_t(components));
        }
        add(point, &values[first]);
      }
    }
  };
  addAll(1, this->Counts, [](std::int64_t, std::int64_t* count) { ++*count; });
  this->Merged += size - std::count(targets, targets + size, NoPoint);
  std::vector<std::pair<const DataArray*, std::vector<FiniteMean>*>> averaged;
  for (const DataArray& array : points)
  {
    if (IsAveraged(array))
    {
      averaged.emplace_back(&array, &this->Means[array.Name]);
    }
  }
  ParallelFor(std::int64_t(averaged.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        const int components = averaged[std::size_t(n)].first->Components();
        averaged[std::size_t(n)].first->WithNumbers(
          [&](const auto* numbers)
          {
            addAll(components, *averaged[std::size_t(n)].second,
              [&](std::int64_t point, FiniteMean* means)
              {
                for (int component = 0; component < components; ++component)
                {
                  means[component].Add(double(numbers[point * components + component]), 1);
                }
              });
          });
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
const std::vector<FiniteMean>* MergedParts::FindMeans(const std::string& name) const
{
  const auto found = this->Means.find(name);
  return found == this->Means.end() ? nullptr : &found->second;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteDropped(const Horizon& input, const DroppedPoints& dropped, const Loops& boundary, Horizon& output)
{
  const KeptPoints kept = KeepOthers(dropped, std::size_t(input.NumberOfPoints()));
  CopyPoints(input, kept, output);
  const Loops loops = RenumberWithout(dropped, boundary);
  output.Lines = MakePolylines(loops);
  UnmarkInside(loops, output);
  if (!dropped.empty())
  {
    output.PointData.Add(AddDropped(ReadCounts(input), kept, dropped));
  }
}
}
