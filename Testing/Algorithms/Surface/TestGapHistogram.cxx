// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps between points, and the radius that spans them.

#include "Filters/Algorithms/Surface/Surface.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <limits>
#include <numeric>

using namespace SeismicHorizons;

namespace
{
Patches::Columns Grid(int width, int height, int stepX, int stepY)
{
  Patches::Columns columns;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      columns.push_back({ x * stepX, y * stepY });
    }
  }
  return columns;
}

/// As many points as leave out each with a chance, in any order.
Patches::Columns Ragged(int side, double missing, Patches::Random& random)
{
  Patches::Columns columns = Grid(side, side, 1, 1);
  columns.erase(
    std::remove_if(columns.begin(), columns.end(), [&](const PlanePoint&) { return random.Chance(missing); }),
    columns.end());
  for (std::size_t n = columns.size(); n > 1; --n)
  {
    std::swap(columns[n - 1], columns[std::size_t(random.Below(int(n)))]);
  }
  return columns;
}

std::int64_t Sum(const GapHistogram& steps)
{
  return std::accumulate(steps.begin(), steps.end(), std::int64_t(0));
}

void TestCounts()
{
  //  y = 2   # . . #
  //  y = 1   . . . .
  //  y = 0   # # . #
  const GapHistograms gaps = CountGaps(Patches::FromPicture({ "#..#", "....", "##.#" }));
  CHECK_EQUAL(gaps.AlongRows[1], 1);
  CHECK_EQUAL(gaps.AlongRows[2], 1);
  CHECK_EQUAL(gaps.AlongRows[3], 1);
  CHECK_EQUAL(Sum(gaps.AlongRows), 3);
  CHECK_EQUAL(gaps.AlongColumns[2], 2);
  CHECK_EQUAL(Sum(gaps.AlongColumns), 2);
  // Beyond the largest radius all are the same, however far; nothing is as large as the box.
  const GapHistograms far = CountGaps({ { 100000000, 5 }, { 0, 5 }, { 33, 5 }, { 0, -100000000 } });
  CHECK_EQUAL(far.AlongRows[LargestRadius + 1], 2);
  CHECK_EQUAL(far.AlongColumns[LargestRadius + 1], 1);
  CHECK_EQUAL(Sum(far.AlongRows) + Sum(far.AlongColumns), 3);
}

void TestRegularData()
{
  CHECK_EQUAL(ChooseRadius(Grid(40, 30, 1, 1)), 1);
  CHECK_EQUAL(ChooseRadius(Grid(40, 30, 1, 2)), 2);
  CHECK_EQUAL(ChooseRadius(Grid(40, 30, 3, 1)), 3);
  CHECK_EQUAL(ChooseRadius(Grid(40, 30, 2, 5)), 5);
  CHECK_EQUAL(ChooseRadius(Grid(5, 5, 32, 1)), 32);
  CHECK_EQUAL(ChooseRadius(Grid(5, 5, 33, 1)), LargestRadius);
}

/// Of points of which a part is missing at random, a step is longer than n with the n-th power of that part.
void TestRaggedData()
{
  Patches::Random random(3);
  for (const auto& [missing, radius] : { std::pair<double, int>{ 0.02, 1 }, { 0.1, 2 }, { 0.2, 2 }, { 0.45, 4 } })
  {
    CHECK_EQUAL(ChooseRadius(Ragged(200, missing, random)), radius);
  }
}

/// Holes and ragged outlines do not count for much.
void TestHolesAndOutlines()
{
  Patches::Columns columns = Grid(100, 100, 1, 1);
  const auto isAway = [](const PlanePoint& column)
  { return (column.X > 30 && column.X < 60 && column.Y > 20 && column.Y < 70) || (column.X / 10) % 4 > column.Y / 10; };
  columns.erase(std::remove_if(columns.begin(), columns.end(), isAway), columns.end());
  CHECK_EQUAL(ChooseRadius(columns), 1);
}

void TestFewPoints()
{
  CHECK_EQUAL(ChooseRadius(PlanePoints{}), 1);
  CHECK_EQUAL(ChooseRadius(PlanePoints{ { 7, 7 } }), 1);
  CHECK_EQUAL(ChooseRadius(PlanePoints{ { 7, 7 }, { 8, 8 } }), 1); // no two in a row
  CHECK_EQUAL(ChooseRadius(PlanePoints{ { 7, 7 }, { 7, 11 } }), 4);
  CHECK_EQUAL(ChooseRadius(PlanePoints{ { -100000000, 7 }, { 100000000, 7 } }), LargestRadius);
}

void TestOrderDoesNotMatter()
{
  Patches::Random random(11);
  for (int n = 0; n < 200; ++n)
  {
    Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const GapHistograms gaps = CountGaps(columns);
    std::sort(columns.begin(), columns.end());
    const GapHistograms sorted = CountGaps(columns);
    CHECK(gaps.AlongRows == sorted.AlongRows && gaps.AlongColumns == sorted.AlongColumns);
    for (PlanePoint& column : columns)
    {
      column = { column.Y, column.X };
    }
    CHECK(CountGaps(columns).AlongRows == sorted.AlongColumns);
  }
}

void TestHoleSizes()
{
  CHECK_EQUAL(ChooseSmallestHoleSize(1, 0.0), 9);
  CHECK_EQUAL(ChooseSmallestHoleSize(1, 1.5), 9);
  CHECK_EQUAL(ChooseSmallestHoleSize(1, 2.0), 16);
  CHECK_EQUAL(ChooseSmallestHoleSize(3, 2.0), 49);
  CHECK_EQUAL(ChooseSmallestHoleSize(1, 1e300), std::int64_t(1) << 28);
  CHECK_EQUAL(ChooseSmallestHoleSize(std::numeric_limits<int>::max(), 0.0), ChooseSmallestHoleSize(LargestRadius, 0.0));
}
}

int TestGapHistogram(int, char*[])
{
  TestCounts();
  TestRegularData();
  TestRaggedData();
  TestHolesAndOutlines();
  TestFewPoints();
  TestOrderDoesNotMatter();
  TestHoleSizes();
  return Check::Result();
}
