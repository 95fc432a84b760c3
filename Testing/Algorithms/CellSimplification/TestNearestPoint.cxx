// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest of some boundary points beside a search through all of them.

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
/// All in one cell, the first points on the boundary: the others count for the nearest of these.
void Compare(int count, std::int32_t size, Patches::Random& random)
{
  constexpr int asked = 100;
  BoundedHorizon horizon;
  for (int n = 0; n < count + asked; ++n)
  {
    const std::int32_t x = random.Below(size) - size / 2;
    horizon.Plane.push_back({ x, random.Below(size) - size / 2 });
    if (n < count)
    {
      horizon.Boundary.Append(n);
    }
  }
  horizon.Boundary.Close();
  horizon.Height.assign(horizon.Plane.size(), 0.0);
  horizon.Patch.assign(horizon.Plane.size(), 0);
  const Reduction result = SimplifyRough(horizon, 1 << 30);
  for (std::size_t n = std::size_t(count); n < horizon.Plane.size(); ++n)
  {
    const auto boundary = horizon.Plane.begin();
    const auto nearest = std::min_element(boundary, boundary + count,
      [&](const PlanePoint& a, const PlanePoint& b)
      { return SquaredDistance(a, horizon.Plane[n]) < SquaredDistance(b, horizon.Plane[n]); });
    CHECK_EQUAL(result.Target[n], PointId(nearest - boundary));
  }
}
}

int TestNearestPoint(int, char*[])
{
  Patches::Random random(31);
  for (const int count : { 1, 2, 8, 9, 10, 33, 500 })
  {
    // Many at the same distances, some in the same place; and as far apart as sub-voxels can be.
    for (const std::int32_t size : { 2, 6, 40, 1 << 29 })
    {
      Compare(count, size, random);
    }
  }
  return Check::Result();
}
