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

template <typename T>
DataArray AverageAs(const DataArray& array, const MergedPoints& points)
{
  const int components = array.Components();
  DataArray means = NewArray<T>(array.Name.c_str(), points.Size(), components);
  means.ComponentNames = array.ComponentNames;
  means.Role = array.Role;
  T* const to = means.As<T>();
  array.WithNumbers(
    [&](const auto* from)
    {
      ParallelFor(points.Size(), Grain,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first * components; n < last * components; ++n)
          {
            to[n] = static_cast<T>(points.Average(
              n / components, [&](PointId point) { return double(from[components * point + n % components]); }));
          }
        });
    });
  return means;
}

/// Means of float arrays are float, and double otherwise.
DataArray Average(const DataArray& array, const MergedPoints& points)
{
  return array.Type() == ValueType::Float ? AverageAs<float>(array, points) : AverageAs<double>(array, points);
}

void ReduceAttributes(
  const Horizon& input, const std::vector<PointId>& sources, const MergedPoints& points, Horizon& output)
{
  KeptPoints nearest(std::size_t(input.NumberOfPoints()));
  std::for_each(sources.begin(), sources.end(), [&nearest](PointId point) { nearest.Append(point); });
  for (const DataArray& array : input.PointData)
  {
    output.PointData.Add(IsAveraged(array) ? Average(array, points) : array.Select(nearest));
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

DataArray SumCounts(const MergedPoints& points)
{
  DataArray sums = NewArray<std::int64_t>(PointArray::PointCount, points.Size());
  auto* const values = sums.As<std::int64_t>();
  ParallelFor(points.Size(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t target = first; target < last; ++target)
      {
        values[target] = points.SumCounts(target);
      }
    });
  return sums;
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
  output.Vertices = MakeVertices(output.NumberOfPoints());
  output.Lines = MakePolylines(reduction.Boundary);
  ArrayTable& data = output.PointData;
  const MergedPoints points(reduction, ReadCounts(input));
  ReduceAttributes(input, reduction.Source, points, output);
  UnmarkInside(reduction.Boundary, output);
  WriteColumns(reduction, output);
  if (input.PointData.Has(PointArray::PointCount) || output.NumberOfPoints() < input.NumberOfPoints())
  {
    data.Add(SumCounts(points));
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
