// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMeshSampling_h
#define SeismicHorizonsMeshSampling_h

#include "ColumnTiles.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// The heights of a mesh at the columns of a lattice, from (0, 0) on, that it covers. Points and heights are in lattice
/// units.
class MeshSampling
{
public:
  explicit MeshSampling(const std::array<int, 2>& columns)
    : Columns(columns)
  {
  }

  /// A column on the edge of a triangle is on it, and of several triangles over one column the first counts. Throws
  /// InputError where a column is inside a triangle and has another height already.
  void AddTriangles(const std::vector<SpacePoint>& points, const std::vector<std::array<PointId, 3>>& triangles,
    const Monitor& monitor = Monitor());
  /// Spurs of a horizon have no triangles: a point on a column without a height gives it heightOf(point).
  void AddBarePoints(const std::vector<SpacePoint>& points, const std::function<double(std::size_t point)>& heightOf);

  ColumnTiles Tiles;
  std::vector<double> Heights; // by place in the tiles, nan where there is none

private:
  double& At(int i, int j);

  std::array<int, 2> Columns;
};
}

#endif
