// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The columns of triangles, and their largest distances, beside a look at every column of the box.

#include "Decimation/HeightRaster.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <numeric>
#include <set>

using namespace SeismicHorizons;

namespace
{
bool IsInside(const std::array<PlanePoint, 3>& t, const PlanePoint& p)
{
  const auto turn = [&](std::size_t n)
  {
    const PlanePoint& a = t[n];
    const PlanePoint& b = t[(n + 1) % 3];
    return ExactPlane::Cross({ b.X - a.X, b.Y - a.Y }, { p.X - a.X, p.Y - a.Y });
  };
  return turn(0) >= 0 && turn(1) >= 0 && turn(2) >= 0;
}

/// Turned counter-clockwise, anywhere in a square.
std::array<PlanePoint, 3> RandomTriangle(int size, Patches::Random& random)
{
  std::array<PlanePoint, 3> t;
  std::int64_t area = 0;
  while (area == 0)
  {
    for (PlanePoint& corner : t)
    {
      corner = { random.Below(size), random.Below(size) };
    }
    area = SignedArea(t[0], t[1], t[2]);
  }
  if (area < 0)
  {
    std::swap(t[0], t[1]);
  }
  return t;
}

void TestRows(Patches::Random& random)
{
  for (int n = 0; n < 3000; ++n)
  {
    const std::array<PlanePoint, 3> t = RandomTriangle(3 + n % 30, random);
    std::set<PlanePoint> found;
    ForEachRow(t,
      [&](std::int32_t y, std::int32_t first, std::int32_t last)
      {
        for (std::int32_t x = first; x <= last; ++x)
        {
          CHECK(found.insert({ x, y }).second);
        }
      });
    std::set<PlanePoint> expected;
    for (std::int32_t x = 0; x < 33; ++x)
    {
      for (std::int32_t y = 0; y < 33; ++y)
      {
        if (IsInside(t, { x, y }))
        {
          expected.insert({ x, y });
        }
      }
    }
    CHECK(found == expected);
  }
}

void TestMeasure(Patches::Random& random)
{
  Patches::Columns columns;
  std::vector<double> heights;
  for (int n = 0; n < 900; ++n)
  {
    if (random.Chance(0.8))
    {
      columns.push_back({ n % 30, n / 30 });
      heights.push_back(random.Fraction());
    }
  }
  std::vector<PointId> points(columns.size());
  std::iota(points.begin(), points.end(), 0);
  const auto forEachPoint = [&points](auto&& add) { std::for_each(points.begin(), points.end(), add); };
  const HeightRaster raster(forEachPoint, columns, heights);
  for (int n = 0; n < 1000; ++n)
  {
    const std::array<PlanePoint, 3> t = RandomTriangle(30, random);
    const RaisedTriangle raised = { { { t[0], random.Fraction() }, { t[1], random.Fraction() }, { t[2], 2.0 } } };
    HeightError expected;
    raster.ForEachColumn(raised,
      [&](PointId point, double error, const std::array<double, 3>& weights)
      {
        CHECK(IsInside(t, columns[std::size_t(point)]));
        CHECK_EQUAL(weights[0] + weights[1] + weights[2], double(SignedArea(t[0], t[1], t[2])));
        expected = std::abs(error) > expected.Largest ? HeightError{ std::abs(error), point } : expected;
      });
    const HeightError found = raster.Measure(raised);
    CHECK_EQUAL(found.Point, expected.Point);
    CHECK(std::abs(found.Largest - expected.Largest) < 1e-12);
  }
}

/// The error at one column is found whichever columns beside it are missing, of triangles of all widths.
void TestMissingColumns()
{
  for (std::int32_t width = 2; width < 20; ++width)
  {
    const std::array<PlanePoint, 3> t = { { { 0, 0 }, { width, 0 }, { 0, width } } };
    for (std::int32_t x = 0; x + 1 < width; ++x)
    {
      // The box reaches beyond the triangle, so that all of it has places.
      const Patches::Columns columns = { { -1, -1 }, { x, 1 }, { width + 4, width + 4 } };
      const auto forEachPoint = [](auto&& add)
      {
        for (const PointId point : { 0, 1, 2 })
        {
          add(point);
        }
      };
      const HeightRaster raster(forEachPoint, columns, { 0.0, 3.0, 0.0 });
      const HeightError found = raster.Measure({ { { t[0], 1.0 }, { t[1], 1.0 }, { t[2], 1.0 } } }, { 2, 1.0 });
      CHECK_EQUAL(found.Point, 1);
      CHECK_EQUAL(found.Largest, 2.0);
      CHECK_EQUAL(found.Sum, 4.0);
    }
  }
}

/// From (0, 0) to (4, 2) over columns that are all 0 but one: the crossings are half way between columns.
void TestSide()
{
  Patches::Columns columns;
  std::vector<double> heights;
  for (int n = 0; n < 15; ++n)
  {
    columns.push_back({ n % 5, n / 5 });
    heights.push_back(n == 6 ? 8.0 : 0.0); // column (1, 1)
  }
  std::vector<PointId> points(columns.size());
  std::iota(points.begin(), points.end(), 0);
  const auto forEachPoint = [&points](auto&& add) { std::for_each(points.begin(), points.end(), add); };
  const HeightRaster raster(forEachPoint, columns, heights);
  std::vector<unsigned char> marks(columns.size(), 0);
  const RaisedPoint from{ { 0, 0 }, 0.0 };
  const RaisedPoint to{ { 4, 2 }, 0.0 };
  CHECK_EQUAL(raster.MeasureSide(from, to, marks).Largest, 4.0);
  CHECK_EQUAL(raster.MeasureSide(to, from, marks).Largest, 4.0);
  const PointId point = raster.MeasureSide(from, to, marks).Point;
  CHECK(point == 1 || point == 6);
  marks[1] = 1;
  CHECK_EQUAL(raster.MeasureSide(from, to, marks).Point, 6);
  marks[6] = 1;
  CHECK_EQUAL(raster.MeasureSide(from, to, marks).Point, NoPoint);
}
}

int TestHeightRaster(int, char*[])
{
  Patches::Random random(17);
  TestRows(random);
  TestMeasure(random);
  TestMissingColumns();
  TestSide();
  return Check::Result();
}
