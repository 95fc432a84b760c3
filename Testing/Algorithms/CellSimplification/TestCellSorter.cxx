// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points are in which cell, and their order: without a boundary each cell becomes one point, whose height is a
// sum over them in their order.

#include "Common/Horizon/CellGrid.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <cmath>
#include <map>
#include <string>

using namespace SeismicHorizons;

namespace
{
void AddRandomPlaces(
  std::vector<PlanePoint>& places, std::size_t points, int width, int height, Patches::Random& random)
{
  for (std::size_t n = 0; n < points; ++n)
  {
    const int x = random.Below(width) - 1000;
    places.push_back({ x, random.Below(height) - 77 });
  }
}

std::vector<PlanePoint> RandomPlaces(std::size_t points, int width, int height, Patches::Random& random)
{
  std::vector<PlanePoint> places;
  AddRandomPlaces(places, points, width, height, random);
  return places;
}

/// Compares with lists that are made one point after the other.
void CheckSorted(const std::vector<PlanePoint>& places, int cellSize)
{
  BoundedHorizon horizon;
  horizon.Plane = places;
  horizon.Patch.assign(places.size(), 0);
  const CellGrid grid(places, 1, cellSize);
  std::map<std::int64_t, std::vector<PointId>> cells;
  for (std::size_t point = 0; point < places.size(); ++point)
  {
    horizon.Height.push_back(1.0 / double(point + 1));
    cells[grid.CellOf(places[point])].push_back(PointId(point));
  }
  const Reduction result = SimplifyRough(horizon, cellSize);
  CHECK_EQUAL(result.Height.size(), cells.size());
  std::size_t number = 0;
  bool same = true;
  for (const auto& [square, points] : cells)
  {
    double sum = 0.0;
    for (const PointId point : points)
    {
      sum += horizon.Height[point];
      same = same && result.Target[point] == PointId(number);
    }
    same = same && result.Height[number] == sum / double(points.size());
    ++number;
  }
  CHECK(same);
}

/// More points than a batch has, and fewer rows of cells than there can be bands, as many, one more, and several for
/// each band.
void TestAgainstPlainSort()
{
  Patches::Random random(3);
  const std::vector<PlanePoint> places = RandomPlaces(150000, 40, 3000, random);
  for (const int cellSize : { 4, 7, 11, 12, 100, 2000, 1 << 30 })
  {
    CheckSorted(places, cellSize);
  }
  for (const int rows : { 1, 2, 255, 256, 257, 511, 512, 513, 700 })
  {
    CheckSorted(RandomPlaces(2000, 9, rows, random), 1);
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
  CheckSorted(places, 1);
  CheckSorted(places, 2);
}

/// Most cells are empty: everywhere, and in some rows only.
void TestFarApart()
{
  Patches::Random random(5);
  constexpr int far = 1 << 28;
  std::vector<PlanePoint> places = RandomPlaces(1000, far, far, random);
  CheckSorted(places, 1);
  CheckSorted(places, 100000);
  AddRandomPlaces(places, 100000, 100, 100, random);
  AddRandomPlaces(places, 100000, 100, 100, random);
  for (const int cellSize : { 1, 7, 1000000 })
  {
    CheckSorted(places, cellSize);
  }
  places = RandomPlaces(100000, 300, 300, random);
  AddRandomPlaces(places, 200, far, 300, random);
  CheckSorted(places, 3);
}

/// A horizon, and the same once more as another patch so far along both axes.
BoundedHorizon Twice(const BoundedHorizon& horizon, std::int32_t far)
{
  const PointId points = PointId(horizon.Plane.size());
  BoundedHorizon both = horizon;
  both.Count.clear();
  for (PointId point = 0; point < points; ++point)
  {
    both.Plane.push_back({ horizon.Plane[point].X + far, horizon.Plane[point].Y + far });
    both.Height.push_back(horizon.Height[point]);
    both.Patch.push_back(horizon.Patch[point] + 1);
  }
  both.Boundary.AppendLoop(horizon.Boundary.RenumberedBy([points](PointId point) { return point + points; }), 0);
  return both;
}

/// Parts with far more cells between them than memory could hold become what they become alone.
template <typename Simplify>
void CheckFarParts(Simplify&& simplify)
{
  const Patches::Columns columns = Patches::FromPicture(std::vector<std::string>(40, std::string(40, '#')));
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(5.0 + 4.0 * std::sin(0.3 * column.X) * std::cos(0.2 * column.Y));
  }
  const BoundedHorizon horizon = TestHorizons::MakeHorizon(columns, heights);
  constexpr std::int32_t far = 3 << 27; // whole cells of 2, 3 and 8 columns
  const Reduction alone = simplify(horizon);
  const Reduction both = simplify(Twice(horizon, far));
  const std::size_t outline = horizon.Boundary.TotalLength();
  CHECK_EQUAL(both.Plane.size(), 2 * alone.Plane.size());
  for (std::size_t n = 0; n < alone.Plane.size(); ++n)
  {
    const bool isInner = n >= outline; // these come after both outlines
    const std::size_t first = isInner ? n + outline : n;
    const std::size_t second = isInner ? n + alone.Plane.size() : n + outline;
    const PlanePoint& place = alone.Plane[n];
    CHECK(both.Plane[first] == place);
    CHECK(both.Plane[second] == (PlanePoint{ place.X + far, place.Y + far }));
    CHECK_EQUAL(both.Height[first], alone.Height[n]);
    CHECK_EQUAL(both.Height[second], alone.Height[n]);
    CHECK_EQUAL(both.Origin[first].Ring, alone.Origin[n].Ring);
    CHECK_EQUAL(both.Origin[second].Ring, alone.Origin[n].Ring);
  }
}

void TestFarParts()
{
  for (const int cellSize : { 1, 2, 3, 8 })
  {
    CheckFarParts([&](const BoundedHorizon& horizon) { return SimplifyRough(horizon, cellSize); });
    CheckFarParts(
      [&](const BoundedHorizon& horizon) { return SimplifyElaborate(horizon, ElaborateOptions(cellSize, 0.02)); });
  }
}
}

int TestCellSorter(int, char*[])
{
  TestAgainstPlainSort();
  TestRows();
  TestFarApart();
  TestFarParts();
  return Check::Result();
}
