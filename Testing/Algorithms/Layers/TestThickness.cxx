// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Thickness between planes, whose distance is known, on lattices that are turned and sheared in the world.

#include "Layers/Thickness.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace SeismicHorizons;

namespace
{
struct Points
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Heights;

  HorizonView View() const { return { this->Columns, this->Heights.data() }; }
};

template <typename Height>
Points MakePoints(std::int32_t firstX, std::int32_t lastX, std::int32_t lastY, Height&& height)
{
  Points points;
  for (std::int32_t y = 0; y <= lastY; ++y)
  {
    for (std::int32_t x = firstX; x <= lastX; ++x)
    {
      points.Columns.push_back({ x, y });
      points.Heights.push_back(height(x, y));
    }
  }
  return points;
}

bool IsNear(double a, double b)
{
  return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b));
}

// z = g . (x, y) in the world, 5 apart vertically: the distance is 5 / sqrt(1 + g . g), whatever the lattice is like.
void TestParallelPlanes(const LatticeSteps& steps)
{
  const auto height = [&](int i, int j)
  {
    const double x = i * steps.X[0] + j * steps.Y[0];
    const double y = i * steps.X[1] + j * steps.Y[1];
    return (0.3 * x - 0.4 * y) / steps.Height;
  };
  const Points upper = MakePoints(0, 6, 5, [&](int i, int j) { return height(i, j) + 5.0 / steps.Height; });
  const Points lower = MakePoints(2, 9, 4, height);
  const Thickness thickness = MeasureThickness(upper.View(), lower.View(), steps);
  CHECK_EQUAL(thickness.Columns.size(), std::size_t(5 * 5));
  CHECK_EQUAL(thickness.NumberOfCrossings, 0);
  for (std::size_t n = 0; n < thickness.Columns.size(); ++n)
  {
    CHECK(IsNear(thickness.Vertical[n], 5.0));
    CHECK(IsNear(thickness.Normal[n], 5.0 / std::sqrt(1.25)));
    CHECK(upper.Columns[std::size_t(thickness.Points[0][n])] == thickness.Columns[n]);
    CHECK(lower.Columns[std::size_t(thickness.Points[1][n])] == thickness.Columns[n]);
  }
}

// One rises as the other falls: the mean is flat, and the normal one is the vertical one. They cross in the middle.
void TestCrossingPlanes()
{
  const Points upper = MakePoints(0, 4, 2, [](int i, int) { return double(i - 2); });
  const Points lower = MakePoints(0, 4, 2, [](int i, int) { return double(2 - i); });
  const Thickness thickness = MeasureThickness(upper.View(), lower.View());
  CHECK_EQUAL(thickness.NumberOfCrossings, 2 * 3);
  for (std::size_t n = 0; n < thickness.Columns.size(); ++n)
  {
    const double expected = 2.0 * (thickness.Columns[n].X - 2);
    CHECK_EQUAL(thickness.Vertical[n], expected);
    CHECK_EQUAL(thickness.Normal[n], expected);
    CHECK_EQUAL(int(thickness.Crosses[n]), expected < 0.0 ? 1 : 0);
  }
}

void TestSinglePoints()
{
  const Points row = MakePoints(0, 3, 0, [](int, int) { return 1.0; });
  const Points base = MakePoints(3, 6, 0, [](int, int) { return 0.0; });
  const Thickness thickness = MeasureThickness(row.View(), base.View());
  CHECK_EQUAL(thickness.Vertical.size(), std::size_t(1));
  CHECK(std::isnan(thickness.Normal.front()));
  const Points beyond = MakePoints(7, 9, 0, [](int, int) { return 0.0; });
  CHECK_THROWS_WITH(MeasureThickness(row.View(), beyond.View()), "without a column in common, expected");
  Points twice = row;
  twice.Columns[2] = twice.Columns[0];
  CHECK_THROWS_WITH(MeasureThickness(row.View(), twice.View()), "points 0 and 2");
  LatticeSteps flat;
  flat.Y = { 2.0, 0.0 };
  CHECK_THROWS_WITH(MeasureThickness(row.View(), base.View(), flat), "parallel or 0, expected");
}

void TestOrderOfPoints()
{
  const Points upper = MakePoints(0, 3, 3, [](int i, int j) { return 10.0 + i * j; });
  const Points lower = MakePoints(0, 3, 3, [](int i, int j) { return double(i - j); });
  Points turned = lower;
  std::reverse(turned.Columns.begin(), turned.Columns.end());
  std::reverse(turned.Heights.begin(), turned.Heights.end());
  const Thickness one = MeasureThickness(upper.View(), lower.View());
  const Thickness other = MeasureThickness(upper.View(), turned.View());
  CHECK(one.Vertical == other.Vertical && one.Normal == other.Normal && one.Columns == other.Columns);
}
}

int TestThickness(int, char*[])
{
  TestParallelPlanes(LatticeSteps());
  TestParallelPlanes({ { 12.5, 0.0 }, { 0.0, 25.0 }, -2.0 });
  TestParallelPlanes({ { 8.0, 6.0 }, { -3.0, 20.0 }, 0.5 });
  TestCrossingPlanes();
  TestSinglePoints();
  TestOrderOfPoints();
  return Check::Result();
}
