// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/CellGrid.h"
#include "Filters/Algorithms/Triangulation/SearchGrid.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <set>

using namespace SeismicHorizons;

namespace
{
/// Cells begin at a multiple of the unit, also below 0, and end with the greatest point.
void TestExtent()
{
  const CellGrid grid({ { -13, 21 }, { 50, 44 } }, 10, 4);
  CHECK(grid.Corner(0) == (PlanePoint{ -20, 20 }));
  CHECK_EQUAL(grid.SizeX(), 18); // the last one from 48 to 51
  CHECK_EQUAL(grid.SizeY(), 7);
  CHECK_EQUAL(grid.Size(), 18 * 7);
  CHECK(grid.Corner(grid.Index(3, 2)) == (PlanePoint{ -8, 28 }));
  CHECK_EQUAL(CellGrid({ { -20, 20 }, { 51, 47 } }, 10, 4).Size(), 18 * 7);
  CHECK_EQUAL(CellGrid({ { -20, 20 }, { 52, 47 } }, 10, 4).SizeX(), 19);
  CHECK_EQUAL(CellGrid({ { 5, 5 } }, 1, std::int64_t(1) << 40).Size(), 1);
}

/// Whole coordinates are in the same cell by whichever way it is found, whatever the side of a cell; others outside the
/// box are in the nearest one.
void TestCellsOfPlaces()
{
  for (int side = 1; side < 130; ++side)
  {
    const CellGrid grid({ { -300, -200 }, { 300, 400 } }, 1, side);
    for (int n = 0; n <= 600; ++n)
    {
      const PlanePoint place{ n - 300, n - 200 };
      CHECK_EQUAL(grid.CellX(place.X), n / side);
      CHECK_EQUAL(grid.CellY(place.Y), n / side);
      CHECK_EQUAL(grid.CellOf(place), grid.Index(n / side, n / side));
    }
    CHECK_EQUAL(grid.CellX(-1000.0), 0);
    CHECK_EQUAL(grid.CellY(1000.0), grid.SizeY() - 1);
  }
}

/// Whether a segment touches the half open cell, by clipping it to one side of the cell after the other.
bool Touches(const CellGrid& grid, std::int64_t cell, const PlanePoint& a, const PlanePoint& b, double slack)
{
  const PlanePoint low = grid.Corner(cell);
  const double side = double(grid.CellSize());
  double first = 0.0;
  double last = 1.0;
  const auto clip = [&](double from, double to, double least)
  {
    const double lower = least - slack - from;
    const double upper = least + side + slack - from;
    if (to == from)
    {
      last = lower < 0.0 && 0.0 < upper ? last : -1.0;
      return;
    }
    first = std::max(first, std::min(lower / (to - from), upper / (to - from)));
    last = std::min(last, std::max(lower / (to - from), upper / (to - from)));
  };
  clip(a.X, b.X, low.X);
  clip(a.Y, b.Y, low.Y);
  return first <= last;
}

/// All cells that the segment reaches well into, each once, row by row, and none that it misses by more than the slack.
void TestCellsAlongSegments()
{
  Patches::Random random(2);
  const CellGrid grid({ { -50, -40 }, { 60, 70 } }, 1, 7);
  for (int n = 0; n < 3000; ++n)
  {
    const PlanePoint a{ random.Below(110) - 50, random.Below(110) - 40 };
    const PlanePoint b{ random.Chance(0.1) ? a.X : random.Below(110) - 50, random.Below(110) - 40 };
    std::vector<std::int64_t> cells;
    grid.ForEachCellAlong(a, b, [&cells](std::int64_t cell) { cells.push_back(cell); });
    CHECK(std::is_sorted(cells.begin(), cells.end()));
    const std::set<std::int64_t> found(cells.begin(), cells.end());
    CHECK_EQUAL(found.size(), cells.size());
    for (std::int64_t cell = 0; cell < grid.Size(); ++cell)
    {
      CHECK(found.count(cell) == 1 || !Touches(grid, cell, a, b, -1e-9));
      CHECK(found.count(cell) == 0 || Touches(grid, cell, a, b, 2.0 * SegmentSlack));
    }
  }
}

/// Cells that a segment reaches by less than a thousandth, or just touches at their least corner.
void TestSlivers()
{
  const auto passes = [](const CellGrid& grid, const PlanePoint& a, const PlanePoint& b, std::int64_t wanted)
  {
    bool found = false;
    grid.ForEachCellAlong(a, b, [&](std::int64_t cell) { found = found || cell == wanted; });
    return found;
  };
  const CellGrid tall({ { 0, 0 }, { 100, 4000 } }, 1, 10);
  CHECK(passes(tall, { 69, 2 }, { 71, 4000 }, tall.Index(6, 200))); // at (70 - 1/1999, 2000)
  CHECK(passes(tall, { 69, 0 }, { 71, 3998 }, tall.Index(7, 199))); // at (70 + 1/1999, 2000)
  Patches::Random random(4);
  const CellGrid grid({ { 0, 0 }, { 2000, 2000 } }, 1, 7);
  for (int n = 0; n < 3000; ++n)
  {
    const PlanePoint corner{ 7 * (100 + random.Below(50)), 7 * (100 + random.Below(50)) };
    const PlanePoint way{ 1 + random.Below(300), 1 + random.Below(300) };
    CHECK(passes(grid, { corner.X - way.X, corner.Y + way.Y }, { corner.X + 2 * way.X, corner.Y - 2 * way.Y },
      grid.CellOf(corner)));
  }
}

/// Coordinates count from the least, in the largest power of two that all distances are multiples of.
void TestPlaneFrame()
{
  const std::vector<PlanePoint> places = { { 13, -5 }, { 13 + 24, -5 - 16 }, { 13 - 8, -5 + 40 } };
  const PlaneFrame frame(places);
  CHECK(frame.Least == (PlanePoint{ 5, -21 }));
  CHECK(frame.Greatest == (PlanePoint{ 37, 35 }));
  CHECK_EQUAL(frame.Shift, 3);
  CHECK(frame.Inward(places[0]) == (PlanePoint{ 1, 2 }));
  for (const PlanePoint& place : places)
  {
    CHECK(frame.Outward(frame.Inward(place)) == place);
  }
  CHECK_EQUAL(PlaneFrame({ { 0, 0 }, { 8, 1 } }).Shift, 0);
  CHECK_EQUAL(PlaneFrame({ { 0, 0 }, { 1, 8 } }).Shift, 0);
  CHECK_EQUAL(PlaneFrame({ { 7, 7 } }).Shift, 0);
}
}

int TestCellGrid(int, char*[])
{
  TestExtent();
  TestCellsOfPlaces();
  TestCellsAlongSegments();
  TestSlivers();
  TestPlaneFrame();
  return Check::Result();
}
