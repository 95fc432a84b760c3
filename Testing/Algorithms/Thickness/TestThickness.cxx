// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thickness between two horizons: exact on planes, turned and sheared; gaps, crossings, faults, errors.

#include "Filters/Algorithms/Thickness/Thickness.h"

#include "Tools/Check.h"

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace SeismicHorizons;

namespace
{
struct Layer
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Height;

  HorizonView View() const { return { this->Columns, this->Height.data() }; }
};

using HeightOf = std::function<double(int, int)>;

Layer Make(int width, int height, const HeightOf& heightOf)
{
  Layer layer;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const double z = heightOf(i, j);
      if (!std::isnan(z))
      {
        layer.Columns.push_back({ i - 3, j + 5 });
        layer.Height.push_back(z);
      }
    }
  }
  return layer;
}

/// Two parallel planes in a turned and sheared survey: all columns have the thickness of the plane's distance.
void TestPlanes()
{
  LatticeScale scale;
  scale.Plane << 12.5, -3.0, 4.0, 25.0;
  scale.Height = -4.0;
  // z = 0.3 x - 0.7 y in the world, less 40 and 100.
  const auto plane = [&](double depth)
  {
    return Make(9, 7,
      [&, depth](int i, int j)
      {
        const Eigen::Vector2d place = scale.Plane * Eigen::Vector2d(i, j);
        return (0.3 * place.x() - 0.7 * place.y() - depth) / scale.Height;
      });
  };
  const Layer top = plane(40.0);
  const Layer base = plane(100.0);
  for (const bool isTurned : { false, true }) // whichever is the first one
  {
    const Thickness found =
      isTurned ? MeasureThickness(base.View(), top.View(), scale) : MeasureThickness(top.View(), base.View(), scale);
    CHECK_EQUAL(found.Columns, 63);
    CHECK_EQUAL(found.Crossings, 0);
    for (std::size_t n = 0; n < found.Isochore.size(); ++n)
    {
      CHECK(std::abs(found.Isochore[n] - 60.0) < 1e-9);
      CHECK(std::abs(found.Isopach[n] - 60.0 / std::sqrt(1.0 + 0.09 + 0.49)) < 1e-9);
    }
    CHECK(std::abs(found.Mean - 60.0) < 1e-9 && std::abs(found.Least - 60.0) < 1e-9);
    CHECK(std::abs(found.Volume - 63.0 * 60.0 * (12.5 * 25.0 + 3.0 * 4.0)) < 1e-6);
  }
}

/// Columns that one of the two does not have have no thickness; the dip of those beside them is that of the other side.
void TestGaps()
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Layer top = Make(5, 4, [&](int i, int j) { return i == 1 && j == 1 ? none : 10.0 + i; });
  const Layer base = Make(7, 3, [&](int i, int j) { return i == 3 && j == 0 ? none : 4.0 + i; });
  const Thickness found = MeasureThickness(top.View(), base.View(), LatticeScale());
  CHECK_EQUAL(found.Isochore.size(), 19u);
  CHECK_EQUAL(found.Columns, 5 * 3 - 2);
  for (std::size_t n = 0; n < found.Isochore.size(); ++n)
  {
    const PlanePoint column = top.Columns[n];
    const bool isThere = column.Y < 5 + 3 && !(column.X == 0 && column.Y == 5);
    CHECK_EQUAL(std::isnan(found.Isochore[n]), !isThere);
    CHECK(!isThere || std::abs(found.Isochore[n] - 6.0) < 1e-12);
    CHECK(!isThere || std::isnan(found.Isopach[n]) || std::abs(found.Isopach[n] - 6.0 / std::sqrt(2.0)) < 1e-12);
  }
  // Of a single row the dip across it is not known.
  const Layer row = Make(5, 1, [](int, int) { return 1.0; });
  const Layer under = Make(5, 1, [](int, int) { return 0.0; });
  const Thickness line = MeasureThickness(row.View(), under.View(), LatticeScale());
  CHECK(line.Mean == 1.0 && std::isnan(line.Isopach[2]));
}

/// Where they cross thickness is negative, adds no volume, and is counted; a fault does not change the dip.
/// Rows that are far apart represent no bins between them.
void TestFarRows()
{
  const Layer all = Make(20, 101, [](int, int) { return 0.0; });
  LatticeScale scale;
  scale.Height = 1.0;
  for (const int apart : { 1, 2, 4, 20, 25, 50, 100 })
  {
    const Layer rows = Make(20, 101, [apart](int, int j) { return j % apart == 0 ? 10.0 : std::nan(""); });
    const Thickness found = MeasureThickness(all.View(), rows.View(), scale);
    const std::int64_t common = 20 * (100 / apart + 1);
    CHECK_EQUAL(found.Columns, common);
    CHECK_EQUAL(found.Volume, 10.0 * double(common * (apart <= 32 ? apart : 1)) * scale.Plane.determinant());
    CHECK_EQUAL(found.LeftOut, apart <= 32 ? 0 : 101 * 20 - common);
  }
}

void TestCrossingsAndFaults()
{
  const Layer top = Make(10, 10, [](int i, int) { return i < 8 ? 5.0 : -1.0; });
  const Layer base = Make(10, 10, [](int, int) { return 0.0; });
  const Thickness found = MeasureThickness(top.View(), base.View(), LatticeScale());
  CHECK_EQUAL(found.Crossings, 20);
  CHECK(found.Least == -1.0 && found.Largest == 5.0 && found.Volume == 400.0);
  const Layer thrown = Make(10, 10, [](int i, int) { return i < 5 ? 100.0 : 20.0; });
  const Layer under = Make(10, 10, [](int i, int) { return i < 5 ? 90.0 : 10.0; });
  for (const double isopach : MeasureThickness(thrown.View(), under.View(), LatticeScale()).Isopach)
  {
    CHECK(isopach == 10.0);
  }
}

/// Beside sums and dips that are made here, column by column, on rough horizons with many gaps.
void TestRandom()
{
  std::mt19937 random(5);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int run = 0; run < 200; ++run)
  {
    const int width = 1 + int(random() % 12);
    const int height = 1 + int(random() % 12);
    const double gaps = draw(0.0, 0.6);
    const auto rough = [&](double level)
    {
      return Make(width, height,
        [&, level](int, int)
        { return draw(0.0, 1.0) < gaps ? std::numeric_limits<double>::quiet_NaN() : level + draw(-3.0, 3.0); });
    };
    const Layer top = rough(2.0);
    const Layer base = rough(0.0);
    std::vector<double> under(10000, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t n = 0; n < base.Columns.size(); ++n)
    {
      under[std::size_t(100 * base.Columns[n].Y + base.Columns[n].X + 50)] = base.Height[n];
    }
    std::vector<double> expected;
    int balance = 0;
    int columns = 0;
    for (std::size_t n = 0; n < top.Columns.size(); ++n)
    {
      const double z = top.Height[n] - under[std::size_t(100 * top.Columns[n].Y + top.Columns[n].X + 50)];
      expected.push_back(z);
      balance += z > 0.0 ? 1 : z < 0.0 ? -1 : 0;
      columns += std::isnan(z) ? 0 : 1;
    }
    if (columns == 0)
    {
      CHECK_THROWS_WITH(MeasureThickness(top.View(), base.View(), LatticeScale()), "no column with points of both");
      continue;
    }
    const Thickness found = MeasureThickness(top.View(), base.View(), LatticeScale());
    CHECK_EQUAL(found.Columns, columns);
    for (std::size_t n = 0; n < expected.size(); ++n)
    {
      const double z = balance < 0 ? -expected[n] : expected[n];
      CHECK(std::isnan(z) ? std::isnan(found.Isochore[n]) : found.Isochore[n] == z);
      CHECK(std::isnan(found.Isopach[n]) || std::abs(found.Isopach[n]) <= std::abs(z));
    }
  }
}

void TestErrors()
{
  const Layer top = Make(3, 3, [](int, int) { return 1.0; });
  Layer base = Make(3, 3, [](int, int) { return 0.0; });
  base.Columns[1] = base.Columns[0];
  CHECK_THROWS_WITH(MeasureThickness(top.View(), base.View(), LatticeScale()),
    "points 0 and 1 both in column (-3, 5), expected at most one point of a horizon in a column");
}
}

int TestThickness(int, char*[])
{
  TestPlanes();
  TestGaps();
  TestFarRows();
  TestCrossingsAndFaults();
  TestRandom();
  TestErrors();
  return Check::Result();
}
