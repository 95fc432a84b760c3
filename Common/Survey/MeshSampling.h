// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMeshSampling_h
#define SeismicHorizonsMeshSampling_h

#include "ColumnTiles.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Heights of a mesh at the columns of a lattice, from (0, 0), in lattice units.
class MeshSampling
{
public:
  explicit MeshSampling(const std::array<int, 2>& columns)
    : Columns(columns)
  {
  }

  /// Edges belong to triangles, and the first triangle over a column counts. Throws InputError if a column inside a
  /// triangle already has another height.
  void AddTriangles(const std::vector<SpacePoint>& points, const std::vector<std::array<PointId, 3>>& triangles,
    const Monitor& monitor = Monitor());
  /// Spurs of a horizon have no triangles; their points give heightOf(point) to columns without a height.
  void AddBarePoints(const std::vector<SpacePoint>& points, const std::function<double(std::size_t point)>& heightOf);

  ColumnTiles Tiles;
  std::vector<double> Heights; // Indexed by Tiles; nan without a height.

private:
  double& At(int i, int j);

  std::array<int, 2> Columns;
};
}

#endif
