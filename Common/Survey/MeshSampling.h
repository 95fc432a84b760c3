// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMeshSampling_h
#define SeismicHorizonsMeshSampling_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
/// The heights of a mesh over the columns of a lattice, from (0, 0) on, that of column (i, j) at i + j * columns[0];
/// nan where there is no triangle. Points and heights are in lattice units. A column on the side of a triangle is on
/// it; of several triangles over one column the first counts. Time is linear in the columns that triangles cover and
/// the triangles.
std::vector<double> SampleMesh(const std::vector<SpacePoint>& points,
  const std::vector<std::array<PointId, 3>>& triangles, const std::array<int, 2>& columns,
  const Monitor& monitor = Monitor());
}

#endif
