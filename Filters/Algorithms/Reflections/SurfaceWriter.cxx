// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceWriter.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace SeismicHorizons
{
namespace
{
struct SurfaceSize
{
  std::size_t Sign = 0;
  PointId Surface = NoPoint;
  PointId Columns = 0;
};

/// Calls visit(column, surface) for each pick of a surface.
template <typename Visit>
void ForEachPick(const ReflectionPicks& picks, const RawVector<PointId>& surfaces, Visit&& visit)
{
  for (std::size_t column = 0; column + 1 < picks.Starts.size(); ++column)
  {
    for (PointId pick = picks.Starts[column]; pick < picks.Starts[column + 1]; ++pick)
    {
      if (surfaces[std::size_t(pick)] != NoPoint)
      {
        visit(std::int32_t(column), surfaces[std::size_t(pick)]);
      }
    }
  }
}

/// Appends the surfaces of at least that many columns, in the order of their first picks.
void ListSizes(const ReflectionPicks& picks, const RawVector<PointId>& surfaces, std::size_t sign,
  std::int64_t smallestSize, std::vector<SurfaceSize>& sizes)
{
  struct Extent
  {
    PointId Columns = 0;
    std::int32_t LastColumn = -1;
  };
  std::vector<Extent> extents(surfaces.size());
  ForEachPick(picks, surfaces,
    [&](std::int32_t column, PointId surface)
    {
      Extent& extent = extents[std::size_t(surface)];
      extent.Columns += extent.LastColumn == column ? 0 : 1;
      extent.LastColumn = column;
    });
  ForEachPick(picks, surfaces,
    [&](std::int32_t, PointId surface)
    {
      PointId& columns = extents[std::size_t(surface)].Columns;
      if (columns >= smallestSize)
      {
        sizes.push_back({ sign, surface, columns });
        columns = 0; // it is listed
      }
    });
}

/// Gives each pick the position of its surface among those that are taken, or NoPoint.
void Renumber(const std::vector<SurfaceSize>& sizes, std::size_t sign, RawVector<PointId>& surfaces)
{
  std::vector<PointId> positions(surfaces.size(), NoPoint);
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    if (sizes[n].Sign == sign)
    {
      positions[std::size_t(sizes[n].Surface)] = PointId(n);
    }
  }
  for (PointId& surface : surfaces)
  {
    surface = surface == NoPoint ? NoPoint : positions[std::size_t(surface)];
  }
}

/// A pick of a surface that is taken.
struct Taken
{
  int I = 0;
  PointId Position = NoPoint;
  Reflection Pick;
};

class Writer
{
public:
  Writer(const TraceCube& cube, const CubeReflections& reflections, const std::array<RawVector<PointId>, 2>& positions)
    : Cube(cube)
    , Reflections(reflections)
    , Positions(positions)
  {
  }

  /// Rows are read by all threads, some at a time, and written one after the other.
  void Write(std::vector<HorizonVoxels>& horizons, const Monitor& monitor) const
  {
    constexpr int rowsAtATime = 32;
    std::array<std::vector<Taken>, rowsAtATime> rows;
    for (int first = 0; first < this->Cube.Size[1]; first += rowsAtATime)
    {
      monitor.Progress(double(first) / double(this->Cube.Size[1]));
      const int count = std::min(rowsAtATime, this->Cube.Size[1] - first);
      ParallelFor(count, 1,
        [&](std::int64_t begin, std::int64_t end)
        {
          for (std::int64_t n = begin; n < end; ++n)
          {
            this->ReadRow(first + int(n), rows[std::size_t(n)]);
          }
        });
      for (int n = 0; n < count; ++n)
      {
        for (const Taken& taken : rows[std::size_t(n)])
        {
          Add(horizons[std::size_t(taken.Position)], taken, first + n);
        }
      }
    }
  }

private:
  void ReadRow(int j, std::vector<Taken>& row) const
  {
    row.clear();
    std::vector<float> block;
    std::vector<Reflection> found;
    ForEachTrace(this->Cube, j, block,
      [&](int i, const float* trace)
      {
        found.clear();
        FindReflections(trace, this->Cube.Size[2], this->Reflections.Rules, found);
        std::array<PointId, 2> next;
        for (const std::size_t sign : { 0, 1 })
        {
          const ReflectionPicks& picks = this->Reflections.BySign[sign];
          next[sign] = picks.Begin(picks.ColumnAt(i, j));
        }
        for (const Reflection& reflection : found)
        {
          const int sign = this->Reflections.SignOf(reflection);
          if (sign >= 0)
          {
            const auto pick = std::size_t(next[std::size_t(sign)]++);
            const PointId position = this->Positions[std::size_t(sign)][pick];
            if (position != NoPoint)
            {
              row.push_back({ i, position, reflection });
            }
          }
        }
      });
  }

  static void Add(HorizonVoxels& horizon, const Taken& taken, int j)
  {
    const Reflection& pick = taken.Pick;
    if (!horizon.I.empty() && horizon.I.back() == taken.I && horizon.J.back() == j)
    {
      ++horizon.DroppedDuplicates;
      if (std::abs(pick.Amplitude) <= std::abs(horizon.Amplitude.back()))
      {
        return;
      }
      ForEachVoxelArray(horizon, [](auto& values) { values.pop_back(); });
    }
    horizon.I.push_back(taken.I);
    horizon.J.push_back(j);
    horizon.K.push_back(NearestSample(pick.Place));
    horizon.Thickness.push_back(pick.Thickness);
    horizon.Amplitude.push_back(pick.Amplitude);
    horizon.RealZ.push_back(InSamples(pick.Place));
  }

  const TraceCube& Cube;
  const CubeReflections& Reflections;
  const std::array<RawVector<PointId>, 2>& Positions;
};
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSurfaces(const TraceCube& cube, const CubeReflections& reflections,
  std::array<RawVector<PointId>, 2>& surfaces, std::int64_t smallestSize, std::int64_t largestNumber,
  Extraction& result, const Monitor& monitor)
{
  std::vector<SurfaceSize> sizes;
  for (const std::size_t sign : { 0, 1 })
  {
    ListSizes(reflections.BySign[sign], surfaces[sign], sign, smallestSize, sizes);
  }
  std::stable_sort(
    sizes.begin(), sizes.end(), [](const SurfaceSize& a, const SurfaceSize& b) { return a.Columns > b.Columns; });
  result.NumberOfSurfaces = std::int64_t(sizes.size());
  sizes.resize(std::size_t(std::min(largestNumber, result.NumberOfSurfaces)));
  result.Surfaces.resize(sizes.size());
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    result.Surfaces[n].SurfaceId = int(n) + 1;
    const auto size = std::size_t(sizes[n].Columns);
    ForEachVoxelArray(result.Surfaces[n], [size](auto& values) { values.Reserve(size); });
  }
  for (const std::size_t sign : { 0, 1 })
  {
    Renumber(sizes, sign, surfaces[sign]);
  }
  Writer(cube, reflections, surfaces).Write(result.Surfaces, monitor);
}
}
