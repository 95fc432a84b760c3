// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Despiking/Despiking.h"

#include "Common/Parallel.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace SeismicHorizons;

namespace
{
using Kinds = std::vector<SpikeKind>;

Patches::Columns Rectangle(int width, int height)
{
  return Patches::FromPicture(std::vector<std::string>(std::size_t(height), std::string(std::size_t(width), '#')));
}

std::size_t Count(const Kinds& kinds, SpikeKind kind)
{
  return std::size_t(std::count(kinds.begin(), kinds.end(), kind));
}

/// Spikes on a dipping plane, alone, in a cluster, and at the corner.
void TestSpikes()
{
  const Patches::Columns columns = Rectangle(20, 16);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(0.5 * column.X - 0.3 * column.Y);
  }
  CHECK_EQUAL(Count(FindSpikes(columns, heights, {}), SpikeKind::None), columns.size());
  for (const std::size_t spike : { 0, 65, 105, 106, 125, 319 })
  {
    heights[spike] += spike % 2 == 0 ? 6.0 : -6.0;
  }
  const Kinds kinds = FindSpikes(columns, heights, {});
  for (const std::size_t spike : { 0, 65, 105, 106, 125, 319 })
  {
    CHECK(kinds[spike] == SpikeKind::Spike);
  }
  CHECK_EQUAL(Count(kinds, SpikeKind::Spike), 6u);
  DespikingOptions high;
  high.Threshold = 8.0;
  CHECK_EQUAL(Count(FindSpikes(columns, heights, high), SpikeKind::Spike), 0u);
}

/// Exactly at the threshold is no spike.
void TestThreshold()
{
  const Patches::Columns columns = Rectangle(5, 5);
  std::vector<double> heights(columns.size(), 2.0);
  heights[12] = 6.0;
  CHECK_EQUAL(Count(FindSpikes(columns, heights, {}), SpikeKind::Spike), 0u);
  heights[12] = 6.0 + 1e-12;
  CHECK(FindSpikes(columns, heights, {})[12] == SpikeKind::Spike);
}

/// The points along a straight fault are no spikes, but for the sharp corners that it makes with the rim; nor is a
/// point with few others around.
void TestFaultsAndLonePoints()
{
  const Patches::Columns columns = Rectangle(20, 20);
  for (const bool isSlanted : { false, true })
  {
    std::vector<double> heights;
    for (const PlanePoint& column : columns)
    {
      heights.push_back((isSlanted ? column.X + column.Y > 20 : column.X > 9) ? 50.0 : 0.0);
    }
    const Kinds kinds = FindSpikes(columns, heights, {});
    for (std::size_t point = 0; point < kinds.size(); ++point)
    {
      const PlanePoint& column = columns[point];
      const bool isInside = std::min(column.X, column.Y) >= 2 && std::max(column.X, column.Y) < 18;
      CHECK(!isInside || kinds[point] == SpikeKind::None);
    }
    CHECK_EQUAL(Count(kinds, SpikeKind::Spike), isSlanted ? 4u : 0u);
  }
  CHECK_EQUAL(Count(FindSpikes({ { 0, 0 }, { 1, 0 }, { 2, 0 } }, { 0.0, 100.0, 0.0 }, {}), SpikeKind::Spike), 0u);
  CHECK(FindSpikes({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } }, { 0.0, 100.0, 0.0, 0.0 }, {})[1] == SpikeKind::Spike);
  CHECK(FindSpikes({}, {}, {}).empty());
}

Kinds Threads(const std::vector<std::string>& picture, int width)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  DespikingOptions options;
  options.ThreadWidth = width;
  return FindSpikes(columns, std::vector<double>(columns.size(), 0.0), options);
}

void TestThreads()
{
  // Two squares, a bridge of two columns, a spur, and a hair.
  const std::vector<std::string> picture = { "###..###", "########", "########", "###..###", ".#......", ".#......" };
  CHECK_EQUAL(Count(Threads(picture, 0), SpikeKind::Thread), 0u);
  CHECK_EQUAL(Count(Threads(picture, 1), SpikeKind::Thread), 2u);
  CHECK_EQUAL(Count(Threads(picture, 2), SpikeKind::Thread), 2u + 4u);
  CHECK_EQUAL(Count(Threads(picture, 4), SpikeKind::Thread), 30u);
  const Kinds one = Threads(picture, 1);
  CHECK(one[0] == SpikeKind::Thread && one[1] == SpikeKind::Thread); // the lowest rows
}

/// By definition: whether one of the squares that cover a point is full.
bool IsCovered(const std::map<std::pair<int, int>, bool>& there, int x, int y, int side)
{
  for (int y0 = y - side + 1; y0 <= y; ++y0)
  {
    for (int x0 = x - side + 1; x0 <= x; ++x0)
    {
      bool isFull = true;
      for (int n = 0; n < side * side; ++n)
      {
        isFull = isFull && there.count({ x0 + n % side, y0 + n / side }) > 0;
      }
      if (isFull)
      {
        return true;
      }
    }
  }
  return false;
}

double MedianAround(const Patches::Columns& columns, const std::vector<double>& heights, std::size_t point, int radius)
{
  std::vector<double> around;
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    const int x = std::abs(columns[n].X - columns[point].X);
    const int y = std::abs(columns[n].Y - columns[point].Y);
    if (n != point && x <= radius && y <= radius)
    {
      around.push_back(heights[n]);
    }
  }
  std::sort(around.begin(), around.end());
  const std::size_t half = around.size() / 2;
  return around.size() < 3   ? heights[point]
    : around.size() % 2 == 1 ? around[half]
                             : 0.5 * (around[half - 1] + around[half]);
}

void TestRandomPatches()
{
  Patches::Random random(23);
  for (int n = 0; n < 200; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    std::map<std::pair<int, int>, bool> there;
    std::vector<double> heights;
    for (const PlanePoint& column : columns)
    {
      there[{ column.X, column.Y }] = true;
      heights.push_back(std::floor(10.0 * random.Fraction()));
    }
    const DespikingOptions options = { double(n % 4), 1 + n % 3, n % 5 };
    const Kinds kinds = FindSpikes(columns, heights, options);
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      const bool isSpike =
        std::abs(heights[point] - MedianAround(columns, heights, point, options.Radius)) > options.Threshold;
      const bool isThread =
        options.ThreadWidth > 0 && !IsCovered(there, columns[point].X, columns[point].Y, options.ThreadWidth + 1);
      CHECK(kinds[point] == (isSpike ? SpikeKind::Spike : isThread ? SpikeKind::Thread : SpikeKind::None));
    }
  }
}

void TestThreadsOfTheComputerAndMonitor()
{
  Patches::Random random(9);
  const Patches::Columns columns = Rectangle(300, 200);
  std::vector<double> heights;
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    heights.push_back(10.0 * random.Fraction());
  }
  Detail::NumberOfThreads() = 1;
  const Kinds one = FindSpikes(columns, heights, {});
  Detail::NumberOfThreads() = 3;
  CHECK(FindSpikes(columns, heights, {}) == one);
  Detail::NumberOfThreads() = 2;
  CHECK_EQUAL(MonitorChecker::Check(1, [&](const Monitor& monitor) { FindSpikes(columns, heights, {}, monitor); }),
    std::string());
}

void TestErrors()
{
  const Patches::Columns columns = { { 0, 0 } };
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { -1.0, 2, 0 }), "threshold -1, expected at least 0 lattice units");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { infinity, 2, 0 }), "threshold inf, expected a finite number");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { 4.0, 0, 0 }), "neighborhood radius 0, expected 1 to 16 columns");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { 4.0, 2, -1 }), "thread width -1, expected 0 to 64 columns");
  CHECK_THROWS_WITH(FindSpikes({ { 1, 1 }, { 1, 1 } }, { 0.0, 0.0 }, {}), "points 0 and 1 both in column (1, 1)");
}
}

int TestDespiking(int, char*[])
{
  TestSpikes();
  TestThreshold();
  TestFaultsAndLonePoints();
  TestThreads();
  TestRandomPatches();
  TestThreadsOfTheComputerAndMonitor();
  TestErrors();
  return Check::Result();
}
