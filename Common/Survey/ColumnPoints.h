// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnPoints_h
#define SeismicHorizonsColumnPoints_h

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Horizon.h"
#include "LatticeFrame.h"

#include <cstddef>
#include <cstdint>

namespace SeismicHorizons
{
/// elevation(n) is world z. Points have double precision.
template <typename Elevation>
DataArray MakeColumnPoints(PlanePoints columns, const LatticeMatrix& toWorld, Elevation&& elevation)
{
  auto coordinates = NewArray<double>("Points", std::int64_t(columns.size()), 3);
  auto* const world = coordinates.As<double>();
  ParallelFor(std::int64_t(columns.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
      {
        world[3 * n] = toWorld[0] * columns[n].X + toWorld[1] * columns[n].Y + toWorld[3];
        world[3 * n + 1] = toWorld[4] * columns[n].X + toWorld[5] * columns[n].Y + toWorld[7];
        world[3 * n + 2] = elevation(n);
      }
    });
  return coordinates;
}

/// The array Column, whose memory columns share.
inline DataArray NameColumns(DataArray array)
{
  array.Name = PointArray::Column;
  array.ComponentNames = { "I", "J" };
  return array;
}

inline DataArray NewColumnArray(std::int64_t size)
{
  return NameColumns(DataArray::Make(ValueType::Int, size, 2));
}

inline PlanePoint* ColumnsIn(const DataArray& array)
{
  static_assert(sizeof(PlanePoint) == 2 * sizeof(int), "columns share the memory of the array");
  return reinterpret_cast<PlanePoint*>(array.As<int>());
}

inline DataArray MoveToColumnArray(HeapArray<PlanePoint>& columns)
{
  const auto size = std::int64_t(columns.size());
  void* const memory = columns.Release();
  return NameColumns({ ValueType::Int, size, 2, memory, std::shared_ptr<void>(memory, std::free) });
}
}

#endif
