// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSimplification/CellSorter.h"
#include "Common/CellGrid.h"
#include "Common/Monitor.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
std::vector<PlanePoint> RandomPlaces(std::size_t points, int width, int height, Patches::Random& random)
{
  std::vector<PlanePoint> places;
  for (std::size_t n = 0; n < points; ++n)
  {
    const int x = random.Below(width) - 1000;
    places.push_back({ x, random.Below(height) - 77 });
  }
  return places;
}

/// Compares with lists that are made one point after the other.
void CheckSorted(const CellGrid& grid, const std::vector<PlanePoint>& places)
{
  std::vector<std::uint32_t> begins(std::size_t(grid.Size()) + 1, 0);
  std::vector<PointId> sorted(places.size(), NoPoint);
  SortIntoCells(grid, places, begins, sorted.data(), Monitor());
  begins.back() = std::uint32_t(places.size());
  const PointLists expected = SortByCell(grid, places);
  bool same = true;
  for (std::int64_t cell = 0; cell < grid.Size(); ++cell)
  {
    same = same &&
      std::equal(sorted.data() + begins[std::size_t(cell)], sorted.data() + begins[std::size_t(cell) + 1],
        expected.begin(cell), expected.end(cell));
  }
  CHECK(same);
}

/// More points than a run has, and fewer rows of cells than there can be bands, as many, one more, and several for each
/// band.
void TestAgainstPlainSort()
{
  Patches::Random random(3);
  const std::vector<PlanePoint> places = RandomPlaces(150000, 40, 3000, random);
  for (const std::int64_t cellSize : { 4, 7, 11, 12, 100, 2000, 1 << 30 })
  {
    CheckSorted(CellGrid(places, 1, cellSize), places);
  }
  for (const int rows : { 1, 2, 255, 256, 257, 511, 512, 513, 700 })
  {
    const std::vector<PlanePoint> few = RandomPlaces(2000, 9, rows, random);
    CheckSorted(CellGrid(few, 1, 1), few);
  }
}

/// Points in the order of their rows, as a reader gives them.
void TestRows()
{
  std::vector<PlanePoint> places;
  for (int n = 0; n < 120 * 700; ++n)
  {
    places.push_back({ n % 120, n / 120 });
  }
  CheckSorted(CellGrid(places, 1, 1), places);
  CheckSorted(CellGrid(places, 1, 2), places);
}
}

int TestCellSorter(int, char*[])
{
  TestAgainstPlainSort();
  TestRows();
  return Check::Result();
}
