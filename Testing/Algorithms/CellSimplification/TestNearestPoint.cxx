// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest of some points beside a search through all of them.

#include "CellSimplification/NearestPoint.h"
#include "Common/PlaneGeometry.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <numeric>

using namespace SeismicHorizons;

namespace
{
PointId FindByTrying(const std::vector<PlanePoint>& plane, const PlanePoint& place)
{
  const auto nearest = std::min_element(plane.begin(), plane.end(),
    [&](const PlanePoint& a, const PlanePoint& b) { return SquaredDistance(a, place) < SquaredDistance(b, place); });
  return PointId(nearest - plane.begin());
}

void Compare(int count, std::int32_t size, Patches::Random& random)
{
  const auto place = [&]() { return PlanePoint{ random.Below(size) - size / 2, random.Below(size) - size / 2 }; };
  std::vector<PlanePoint> plane(std::size_t(count), PlanePoint{});
  std::generate(plane.begin(), plane.end(), place);
  std::vector<PointId> points(plane.size());
  std::iota(points.begin(), points.end(), 0);
  const NearestPoint nearest(plane, points);
  for (int n = 0; n < 100; ++n)
  {
    const PlanePoint asked = place();
    CHECK_EQUAL(nearest.Find(asked), FindByTrying(plane, asked));
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
