// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grid that third points are searched in, beside looks at all cells and points.

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/Triangulation/SearchGrid.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <numeric>

using namespace SeismicHorizons;

namespace
{
std::vector<PointId> Names(std::size_t size)
{
  std::vector<PointId> names(size);
  std::iota(names.begin(), names.end(), 0);
  return names;
}

/// How many steps from cell to cell it is to one with boundary edges.
std::int64_t FindEdgeDistance(const SearchGrid& grid, std::int64_t x, std::int64_t y)
{
  std::int64_t least = 255;
  for (std::int64_t otherY = 0; otherY < grid.Cells().SizeY(); ++otherY)
  {
    for (std::int64_t otherX = 0; otherX < grid.Cells().SizeX(); ++otherX)
    {
      if (!grid.Edges().IsEmpty(grid.Cells().Index(otherX, otherY)))
      {
        least = std::min(least, std::max(std::abs(otherX - x), std::abs(otherY - y)));
      }
    }
  }
  return least;
}

void TestEdgeDistances()
{
  Patches::Random random(19);
  for (int n = 0; n < 40; ++n)
  {
    const BoundedHorizon horizon =
      TestHorizons::MakeLevelHorizon(Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random));
    std::vector<PlanePoint> places;
    const PlaneBox box(horizon.Plane);
    for (const PlanePoint& place : horizon.Plane)
    {
      places.push_back({ place.X - box.Least.X, place.Y - box.Least.Y });
    }
    // A few edges only, so that distances grow.
    Loops loop;
    loop.AppendLoop(horizon.Boundary, 0);
    const SearchGrid grid(places, loop, Names(places.size()));
    for (std::int64_t y = 0; y < grid.Cells().SizeY(); ++y)
    {
      for (std::int64_t x = 0; x < grid.Cells().SizeX(); ++x)
      {
        CHECK_EQUAL(grid.EdgeDistance(x, y), FindEdgeDistance(grid, x, y));
      }
    }
  }
}

/// Two points in one place are found, however many others share their cell.
void TestPointsInOnePlace()
{
  std::vector<PlanePoint> places;
  for (int n = 0; n < 12; ++n)
  {
    places.push_back({ 5 * (n % 4), 7 * (n / 4) });
  }
  places.push_back({ 1000, 1000 });
  places.push_back(places[2]);
  CHECK_THROWS_WITH(SearchGrid(places, Loops(), Names(places.size())), "points 2 and 13 ");
}
}

int TestSearchGrid(int, char*[])
{
  TestEdgeDistances();
  TestPointsInOnePlace();
  return Check::Result();
}
