// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks at four points at a time beside looks at one after the other.

#include "Filters/Algorithms/Triangulation/ThirdPointSearch.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace SeismicHorizons;

namespace
{
enum class Kind
{
  Lattice,
  Random,
  NearLine,
  Count
};

/// Points in a square of that size. Those near a line are at most 1 beside it.
std::vector<PlanePoint> MakePlaces(Kind kind, std::int32_t size, Patches::Random& random)
{
  const std::int32_t step = std::max(1, size / 16);
  std::set<PlanePoint> places = { { 0, 0 } };
  for (int n = 0; n < 150; ++n)
  {
    const std::int32_t x = random.Below(size);
    const PlanePoint place = kind == Kind::Lattice
      ? PlanePoint{ x / step * step, random.Below(size) / step * step }
      : (kind == Kind::Random ? PlanePoint{ x, random.Below(size) } : PlanePoint{ x, x / 2 + random.Below(2) });
    places.insert(place);
  }
  return { places.begin(), places.end() };
}

bool IsInside(const CellBox& box, const SearchGrid& grid, const PlanePoint& place)
{
  const std::int64_t x = grid.CellX(place.X);
  const std::int64_t y = grid.CellY(place.Y);
  return box.FirstX <= x && x <= box.LastX && box.FirstY <= y && y <= box.LastY;
}

/// The best of all points in a box, by exact comparisons.
ThirdPointQuery FindBest(const SearchGrid& grid, PointId a, PointId b, const CellBox& box)
{
  ThirdPointQuery query(grid, a, b, nullptr);
  for (PointId point = 0; point < grid.NumberOfPoints(); ++point)
  {
    if (IsInside(box, grid, grid.At(point)))
    {
      query.Consider(point);
    }
  }
  return query;
}

float RadiusFor(const ThirdPointQuery& query, float cotangent)
{
  return 0.5f * std::sqrt((1.0f + cotangent * cotangent) * float(query.SquaredLength()));
}

/// The best point of the box around a circle is found if it is in the circle; and what is in the circle is in the box.
void CompareEdge(const SearchGrid& grid, PointId a, PointId b, float cotangent)
{
  ThirdPointQuery query(grid, a, b, nullptr);
  const CellBox box = CellsOfCircle(query, cotangent, RadiusFor(query, cotangent));
  const CellBox all = { 0, 0, grid.Cells().SizeX() - 1, grid.Cells().SizeY() - 1 };
  for (const CellBox& searched : { box, all })
  {
    ThirdPointQuery scanned(grid, a, b, nullptr);
    ScanBox(scanned, searched, cotangent);
    const ThirdPointQuery expected = FindBest(grid, a, b, searched);
    if (expected.Best != NoPoint && expected.BestCotangent <= cotangent)
    {
      CHECK_EQUAL(scanned.Best, expected.Best);
      CHECK_EQUAL(scanned.BestCotangent, expected.BestCotangent);
      CHECK(IsInside(box, grid, grid.At(expected.Best)));
      // Once more, with the best point known.
      ScanBox(scanned, CellsOfBest(scanned), float(scanned.BestCotangent));
      CHECK_EQUAL(scanned.Best, expected.Best);
    }
    // All visible points up to the bound are considered: here all are.
    ThirdPointQuery visible(grid, a, b, nullptr);
    visible.OnlyVisible = true;
    ScanBox(visible, searched, cotangent);
    CHECK(expected.Best == NoPoint || expected.BestCotangent > cotangent || visible.Best == expected.Best);
  }
}

void TestEdges()
{
  Patches::Random random(23);
  for (int n = 0; n < 120; ++n)
  {
    const std::int32_t size = 1 << (4 + random.Below(25));
    const std::vector<PlanePoint> places = MakePlaces(Kind(n % int(Kind::Count)), size, random);
    std::vector<PointId> names(places.size());
    std::iota(names.begin(), names.end(), 0);
    const SearchGrid grid(places, Loops(), names);
    for (int edge = 0; edge < 50; ++edge)
    {
      const PointId a = random.Below(int(places.size()));
      const PointId b = random.Below(int(places.size()));
      if (a != b)
      {
        CompareEdge(grid, a, b, float(8.0 * random.Fraction() - 2.0));
        CompareEdge(grid, a, b, float(1e9 * random.Fraction()));
      }
    }
  }
}
}

int TestBoxScan(int, char*[])
{
  TestEdges();
  return Check::Result();
}
