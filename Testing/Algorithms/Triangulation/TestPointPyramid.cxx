// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Searches in the boxes of points: they find what a look at all points finds, and look at few of them. What is counted
// is work, not time.

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/Triangulation/SearchGrid.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <limits>
#include <numeric>

using namespace SeismicHorizons;

namespace
{
/// The points of a search, and how many boxes and points it looked at.
struct Nearest
{
  PointId Point = NoPoint;
  std::int64_t Squared = std::numeric_limits<std::int64_t>::max();
  int Looks = 0;
};

Nearest FindNearest(const SearchGrid& grid, const PointPyramid& pyramid, const PlanePoint& place)
{
  Nearest nearest;
  const SegmentEnd middle(place);
  pyramid.Visit(
    [&](const PlaneBox& box)
    {
      ++nearest.Looks;
      return SquaredDistanceToBox(middle, box) <= double(nearest.Squared);
    },
    [&](const PlaneBox& box) { return SquaredDistanceToBox(middle, box); },
    [&](PointId point)
    {
      ++nearest.Looks;
      const std::int64_t squared = SquaredDistance(grid.At(point), place);
      if (squared < nearest.Squared)
      {
        nearest.Squared = squared;
        nearest.Point = point;
      }
    });
  return nearest;
}

void Compare(std::vector<PlanePoint> points, int mostLooks, Patches::Random& random)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<PointId> names(points.size());
  std::iota(names.begin(), names.end(), 0);
  const SearchGrid grid(points, Loops(), names);
  const PointPyramid pyramid(grid);
  const PlanePoint greatest = PlaneBox(points).Greatest;
  for (int n = 0; n < 50; ++n)
  {
    const PlanePoint place{ random.Below(greatest.X + 1), random.Below(greatest.Y + 1) };
    const Nearest nearest = FindNearest(grid, pyramid, place);
    std::int64_t expected = std::numeric_limits<std::int64_t>::max();
    for (const PlanePoint& point : points)
    {
      expected = std::min(expected, SquaredDistance(point, place));
    }
    CHECK_EQUAL(nearest.Squared, expected);
    if (!CHECK(nearest.Looks <= mostLooks))
    {
      std::cerr << nearest.Looks << " looks at " << points.size() << " points\n";
    }
  }
}

/// Spread over a square, and on its rim alone: sixteen times as many points take hardly more looks.
void TestLooks()
{
  Patches::Random random(13);
  for (const int count : { 1000, 16000 })
  {
    std::vector<PlanePoint> spread;
    std::vector<PlanePoint> rim;
    for (int n = 0; n < count; ++n)
    {
      spread.push_back({ random.Below(1 << 20), random.Below(1 << 20) });
      const std::int32_t along = random.Below(1 << 20);
      const std::int32_t side = n % 2 == 0 ? 0 : 1 << 20;
      rim.push_back(n % 4 < 2 ? PlanePoint{ along, side } : PlanePoint{ side, along });
    }
    Compare(spread, 800, random);
    Compare(rim, 800, random);
  }
}
}

int TestPointPyramid(int, char*[])
{
  TestLooks();
  return Check::Result();
}
