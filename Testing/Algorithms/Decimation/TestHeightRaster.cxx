// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The columns of triangles, and their largest distances, beside a look at every column of the box.

#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/Patches.h"

#include <algorithm>
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

PointId NthPoint(std::int64_t n)
{
  return PointId(n);
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

/// A square of 30 columns, one in five without a point; heights are fractions of the rise above a lowest one.
struct RandomColumns
{
  RandomColumns(double lowest, double rise, Patches::Random& random)
  {
    for (int n = 0; n < 900; ++n)
    {
      if (random.Chance(0.8))
      {
        this->Columns.push_back({ n % 30, n / 30 });
        this->Heights.push_back(lowest + rise * random.Fraction());
      }
    }
  }

  HeightRaster MakeRaster() const
  {
    return HeightRaster(std::int64_t(this->Columns.size()), NthPoint, this->Columns, this->Heights.data());
  }

  Patches::Columns Columns;
  std::vector<double> Heights;
};

void TestMeasure(Patches::Random& random)
{
  const RandomColumns square(0.0, 1.0, random);
  const Patches::Columns& columns = square.Columns;
  const HeightRaster raster = square.MakeRaster();
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
    CHECK_EQUAL(raster.FindPoint(raised, found.Largest, 0.0), expected.Point);
    CHECK(std::abs(found.Largest - expected.Largest) < 1e-12);
  }
}

/// Floats decide about bounds as the heights themselves do: right at an error, beside it, and far from it, on high
/// ground and where floats have no part of a bound.
void TestBounds(Patches::Random& random)
{
  for (const double lowest : { 0.0, 1e3, 1e5, 1e9 })
  {
    const RandomColumns square(lowest, 1.0, random);
    const HeightRaster raster = square.MakeRaster();
    for (int n = 0; n < 1000; ++n)
    {
      const std::array<PlanePoint, 3> t = RandomTriangle(n % 2 == 0 ? 30 : 7, random);
      const auto raise = [&](std::size_t corner) { return RaisedPoint{ t[corner], lowest + random.Fraction() }; };
      const RaisedTriangle raised = { raise(0), raise(1), raise(2) };
      const double largest = raster.Measure(raised).Largest;
      const double ofSide = raster.MeasureCrossings(raised[0], raised[1]).Largest();
      for (const double part : { 0.0, 0.5, 1.0 - 1e-8, 1.0, 1.0 + 1e-8, 2.0 })
      {
        CHECK_EQUAL(raster.IsWithin(raised, part * largest), largest <= part * largest);
        CHECK_EQUAL(raster.IsEdgeWithin(raised[0], raised[1], part * ofSide), ofSide <= part * ofSide);
        const HeightError above = raster.MeasureAbove(raised, part * largest);
        CHECK_EQUAL(above.Point != NoPoint, largest > part * largest);
        CHECK(above.Point == NoPoint || std::abs(above.Largest - largest) < 1e-4);
      }
    }
  }
}

/// Four at a time, each column of a square of two triangles is counted once: on the side between these by one of them,
/// and those of corners by none.
void TestOwnedColumns()
{
  for (std::int32_t side = 1; side < 20; ++side)
  {
    Patches::Columns columns;
    for (std::int32_t n = 0; n < (side + 1) * (side + 1); ++n)
    {
      columns.push_back({ n % (side + 1), n / (side + 1) });
    }
    const std::vector<double> heights(columns.size(), 1.0);
    const HeightRaster raster(std::int64_t(columns.size()), NthPoint, columns, heights.data());
    const auto count = [&](const RaisedTriangle& triangle, bool ownsLongSide)
    {
      EdgeColumns sides;
      sides.WithCorners = false;
      sides.Opposite[1] = ownsLongSide;
      double sum = 0.0;
      raster.ForEachFour<float>(triangle, sides,
        [&sum](const auto& errors, const auto&, const auto&, const auto& isIn)
        { sum += double((errors * isIn).sum()); });
      return sum;
    };
    const auto raise = [side](std::int32_t x, std::int32_t y) { return RaisedPoint{ { x * side, y * side }, 2.0 }; };
    const RaisedTriangle low = { raise(0, 0), raise(1, 0), raise(1, 1) };
    const RaisedTriangle high = { raise(1, 1), raise(0, 1), raise(0, 0) };
    CHECK_EQUAL(count(low, true) + count(high, false), double(columns.size() - 4));
    CHECK_EQUAL(count(low, false) + count(high, true), double(columns.size() - 4));
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
      const std::array<double, 3> heights = { 0.0, 3.0, 0.0 };
      const HeightRaster raster(3, NthPoint, columns, heights.data());
      const RaisedTriangle raised = { { { t[0], 1.0 }, { t[1], 1.0 }, { t[2], 1.0 } } };
      const HeightError found = raster.Measure(raised, { true, 1.0 });
      CHECK_EQUAL(raster.FindPoint(raised, found.Largest, 0.0), 1);
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
  const HeightRaster raster(std::int64_t(columns.size()), NthPoint, columns, heights.data());
  std::vector<unsigned char> marks(columns.size(), 0);
  const RaisedPoint from{ { 0, 0 }, 0.0 };
  const RaisedPoint to{ { 4, 2 }, 0.0 };
  CHECK_EQUAL(raster.MeasureEdge(from, to, marks).Largest, 4.0);
  CHECK_EQUAL(raster.MeasureEdge(to, from, marks).Largest, 4.0);
  const PointId point = raster.MeasureEdge(from, to, marks).Point;
  CHECK(point == 1 || point == 6);
  marks[1] = 1;
  CHECK_EQUAL(raster.MeasureEdge(from, to, marks).Point, 6);
  marks[6] = 1;
  CHECK_EQUAL(raster.MeasureEdge(from, to, marks).Point, NoPoint);
}
}

int TestHeightRaster(int, char*[])
{
  Patches::Random random(17);
  TestRows(random);
  TestMeasure(random);
  TestBounds(random);
  TestOwnedColumns();
  TestMissingColumns();
  TestSide();
  return Check::Result();
}
