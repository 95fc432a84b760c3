// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMeshSampling_h
#define SeismicHorizonsMeshSampling_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <array>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// The heights of a mesh over the columns of a lattice, from (0, 0) on: heightAt(i, j) is where that of a column goes,
/// and is asked for columns that have a triangle. It must be nan before. Points and heights are in lattice units. A
/// column on the side of a triangle is on it; of several triangles over one column the first counts. Throws InputError
/// where a column is inside of a triangle and another has another height there. Time is linear in the columns that
/// triangles cover and the triangles.
void SampleMesh(const std::vector<SpacePoint>& points, const std::vector<std::array<PointId, 3>>& triangles,
  const std::array<int, 2>& columns, const std::function<double&(int i, int j)>& heightAt,
  const Monitor& monitor = Monitor());
}

#endif
