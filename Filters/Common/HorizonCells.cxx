// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCells.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
template <typename T>
Cells MakeTrianglesAs(const RawVector<PointId>& triangles)
{
  const auto size = std::int64_t(triangles.size() / 3);
  Cells cells = { NewArray<T>("", size + 1), NewArray<T>("", 3 * size) };
  T* const begins = cells.Offsets.As<T>();
  T* const corners = cells.Points.As<T>();
  begins[size] = T(3 * size);
  ParallelFor(size, Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t triangle = first; triangle < last; ++triangle)
      {
        begins[triangle] = T(3 * triangle);
      }
      std::copy(triangles.data() + 3 * first, triangles.data() + 3 * last, corners + 3 * first);
    });
  return cells;
}
}

//----------------------------------------------------------------------------------------------------------------------
Cells MakePolylines(const Loops& loops)
{
  HeapArray<int> offsets = { 0 };
  HeapArray<int> points;
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    points.append(loops.begin(loop), loops.end(loop));
    points.push_back(*loops.begin(loop));
    offsets.push_back(int(points.size()));
  }
  return { DataArray::Take(offsets), DataArray::Take(points) };
}

//----------------------------------------------------------------------------------------------------------------------
Cells MakeTriangles(const RawVector<PointId>& triangles)
{
  assert(triangles.size() % 3 == 0);
  return triangles.size() <= std::size_t(std::numeric_limits<int>::max()) ? MakeTrianglesAs<int>(triangles)
                                                                          : MakeTrianglesAs<std::int64_t>(triangles);
}

//----------------------------------------------------------------------------------------------------------------------
double WriteTriangles(
  const std::vector<PlanePoint>& plane, const Lattice& lattice, RawVector<PointId> triangles, Horizon& mesh)
{
  const TriangleQuality quality = MeasureQuality(plane, triangles);
  FaceUp(lattice, triangles);
  mesh.Polygons = MakeTriangles(triangles);
  triangles = RawVector<PointId>(); // This frees memory for the arrays, which need as much.
  AddTriangleArray<float>(CellArray::Compactness, quality.Compactness, mesh);
  AddTriangleArray<float>(CellArray::Quality, quality.Shape, mesh);
  return quality.SmallestAngle;
}
}
