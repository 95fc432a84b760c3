// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The error that a mesh has where none is given.

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/HeightNoise.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr double OfRounding = 6.0 / 3.4641016151377544; // whole heights

/// That of heights on a square of columns, `every` apart along both axes.
HeightNoise NoiseOf(const std::function<double(int, int)>& height, int side = 300, int every = 1)
{
  std::vector<PlanePoint> columns;
  std::vector<double> heights;
  for (int y = 0; y < side; y += every)
  {
    for (int x = 0; x < side; x += every)
    {
      columns.push_back({ x - 40, y + 1000 });
      heights.push_back(height(x, y));
    }
  }
  return MeasureHeightNoise(columns, heights);
}

double ErrorOf(const std::function<double(int, int)>& height, int side = 300, int every = 1)
{
  return NoiseOf(height, side, every).MaximumError();
}

bool IsNear(double value, double expected)
{
  return std::abs(value - expected) <= 0.05 * expected;
}

/// Six times the standard deviation, on a slope, over folds and steps, on every column or every second one.
void TestNoise()
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 2.5);
  CHECK(IsNear(ErrorOf([&](int x, int y) { return 3.0 * x - 5.0 * y + noise(random); }), 15.0));
  CHECK(!NoiseOf([&](int, int) { return noise(random); }).IsRounding);
  CHECK(IsNear(ErrorOf([&](int x, int) { return (x < 150 ? 0.0 : 400.0) + noise(random); }), 15.0));
  CHECK(IsNear(ErrorOf([&](int x, int y) { return 90.0 * std::sin(0.03 * x + 0.02 * y) + noise(random); }, 800), 15.0));
  CHECK(IsNear(ErrorOf([&](int x, int) { return 2.0 * x + noise(random); }, 300, 2), 15.0));
  CHECK(IsNear(ErrorOf([&](int x, int) { return 2.0 * x + noise(random); }, 900, 5), 15.0));
}

/// Where rows were interpolated between others, the noise is that along them.
void TestInterpolated()
{
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 2.5);
  std::vector<double> row(300);
  const double error = ErrorOf(
    [&](int x, int y)
    {
      row[std::size_t(x)] = y % 100 == 0 ? noise(random) : row[std::size_t(x)];
      return row[std::size_t(x)];
    });
  CHECK(error > 12.0 && error < 18.0);
}

/// Whole heights, and multiples of less.
void TestRounding()
{
  const auto slope = [](int x, int y) { return 0.37 * x - 0.21 * y + 0.0007 * x * y; };
  const double whole = ErrorOf([&](int x, int y) { return std::round(slope(x, y)); });
  CHECK(whole >= OfRounding && whole < 1.5 * OfRounding);
  const double eighths = ErrorOf([&](int x, int y) { return std::round(8.0 * slope(x, y)) / 8.0; });
  CHECK(eighths >= OfRounding / 8.0 && eighths < 1.5 * OfRounding / 8.0);
}

/// Horizons without noise have an error all the same, and those without neighbours.
void TestWithoutNoise()
{
  CHECK(std::abs(ErrorOf([](int, int) { return 1234.5; }) - OfRounding) < 1e-12);
  CHECK(NoiseOf([](int, int) { return 1234.5; }).IsRounding);
  CHECK(NoiseOf([](int x, int y) { return 0.25 * x + 0.5 * y; }).IsRounding);
  CHECK(NoiseOf([](int x, int y) { return 0.1 * x - 0.3 * y; }).IsRounding);
  const double tilted = ErrorOf([](int x, int y) { return 0.3 * x + 0.1 * y; });
  CHECK(tilted > 1e-3 && tilted <= OfRounding);
  CHECK(ErrorOf([](int x, int y) { return 40.0 * x + 70.0 * y; }) <= 1.001 * OfRounding);
  CHECK(std::abs(ErrorOf([](int, int) { return 7.0; }, 1) - OfRounding) < 1e-12);
  const HeightNoise apart = MeasureHeightNoise(std::vector<PlanePoint>{ { 0, 0 }, { 100000000, 5 } }, { 1.0, 2.0 });
  CHECK(std::abs(apart.MaximumError() - OfRounding) < 1e-12);
  CHECK_EQUAL(MeasureHeightNoise({}, {}).MaximumError(), 0.0);
}

/// Points that are added in parts, with rows beside them, have the noise of all points.
void TestParts()
{
  for (const int every : { 1, 3 })
  {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 2.5);
    std::vector<PlanePoint> columns;
    std::vector<double> heights;
    for (int y = 0; y < 700; y += every)
    {
      for (int x = 0; x < 700; x += every)
      {
        if (random() % 10 != 0)
        {
          columns.push_back({ x, y });
          heights.push_back(0.25 * x + noise(random));
        }
      }
    }
    const HeightNoise whole = MeasureHeightNoise(columns, heights);
    NoiseSampler sampler(columns.size());
    const auto firstOf = [&columns](int row)
    {
      return std::size_t(std::partition_point(
                           columns.begin(), columns.end(), [row](const PlanePoint& column) { return column.Y < row; }) -
        columns.begin());
    };
    int rounds = 0;
    do
    {
      for (int row = 0; row < 700; row += 90)
      {
        const std::size_t before = firstOf(row - sampler.Rim());
        const std::size_t behind = firstOf(row + 90 + sampler.Rim());
        const ColumnIndex index(PlanePoints(columns.data() + before, behind - before));
        sampler.Add(index, { heights.begin() + std::ptrdiff_t(before), heights.begin() + std::ptrdiff_t(behind) },
          before, firstOf(row), firstOf(row + 90));
      }
      ++rounds;
    } while (!sampler.Finish());
    CHECK_EQUAL(rounds, every);
    CHECK_EQUAL(sampler.Noise().Deviation, whole.Deviation);
    CHECK_EQUAL(sampler.Noise().IsRounding, whole.IsRounding);
  }
}
}

int TestHeightNoise(int, char*[])
{
  TestNoise();
  TestInterpolated();
  TestRounding();
  TestWithoutNoise();
  TestParts();
  return Check::Result();
}
