// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/Despiking/Despiking.h"

#include "Common/Base/Parallel.h"
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

const DespikingOptions Four = { 4.0, 2, 0 };

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
  CHECK_EQUAL(Count(FindSpikes(columns, heights, Four).Kind, SpikeKind::None), columns.size());
  for (const std::size_t spike : { 0, 65, 105, 106, 125, 319 })
  {
    heights[spike] += spike % 2 == 0 ? 6.0 : -6.0;
  }
  const Kinds kinds = FindSpikes(columns, heights, Four).Kind;
  for (const std::size_t spike : { 0, 65, 105, 106, 125, 319 })
  {
    CHECK(kinds[spike] == SpikeKind::Spike);
  }
  CHECK_EQUAL(Count(kinds, SpikeKind::Spike), 6u);
  DespikingOptions high;
  high.Threshold = 8.0;
  CHECK_EQUAL(Count(FindSpikes(columns, heights, high).Kind, SpikeKind::Spike), 0u);
}

/// Exactly at the threshold is no spike.
void TestThreshold()
{
  const Patches::Columns columns = Rectangle(5, 5);
  std::vector<double> heights(columns.size(), 2.0);
  heights[12] = 6.0;
  CHECK_EQUAL(Count(FindSpikes(columns, heights, Four).Kind, SpikeKind::Spike), 0u);
  heights[12] = 6.0 + 1e-12;
  CHECK(FindSpikes(columns, heights, Four).Kind[12] == SpikeKind::Spike);
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
    const Kinds kinds = FindSpikes(columns, heights, Four).Kind;
    for (std::size_t point = 0; point < kinds.size(); ++point)
    {
      const PlanePoint& column = columns[point];
      const bool isInside = std::min(column.X, column.Y) >= 2 && std::max(column.X, column.Y) < 18;
      CHECK(!isInside || kinds[point] == SpikeKind::None);
    }
    CHECK_EQUAL(Count(kinds, SpikeKind::Spike), isSlanted ? 4u : 0u);
  }
  CHECK_EQUAL(
    Count(FindSpikes({ { 0, 0 }, { 1, 0 }, { 2, 0 } }, { 0.0, 100.0, 0.0 }, Four).Kind, SpikeKind::Spike), 0u);
  CHECK(
    FindSpikes({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 1, 1 } }, { 0.0, 100.0, 0.0, 0.0 }, Four).Kind[1] == SpikeKind::Spike);
  CHECK(FindSpikes({}, {}, {}).Kind.empty());
}

Kinds Spurs(const std::vector<std::string>& picture, int width)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  DespikingOptions options;
  options.SpurWidth = width;
  return FindSpikes(columns, std::vector<double>(columns.size(), 0.0), options).Kind;
}

void TestSpurs()
{
  // Two squares, a bridge of two columns, a spur, and a hair.
  const std::vector<std::string> picture = { "###..###", "########", "########", "###..###", ".#......", ".#......" };
  CHECK_EQUAL(Count(Spurs(picture, 0), SpikeKind::Spur), 0u);
  CHECK_EQUAL(Count(Spurs(picture, 1), SpikeKind::Spur), 2u);
  CHECK_EQUAL(Count(Spurs(picture, 2), SpikeKind::Spur), 2u + 4u);
  CHECK_EQUAL(Count(Spurs(picture, 4), SpikeKind::Spur), 30u);
  const Kinds one = Spurs(picture, 1);
  CHECK(one[0] == SpikeKind::Spur && one[1] == SpikeKind::Spur); // the lowest rows
}

/// By definition: whether one of the squares that cover a point is full.
bool IsCovered(const std::map<std::pair<int, int>, double>& there, int x, int y, int side)
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

double MedianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// By definition: how far a point is above the plane of medians; 0 where there are too few around.
double DeviationOf(const std::map<std::pair<int, int>, double>& there, const PlanePoint& point, int radius)
{
  const auto isNear = [&](int x, int y)
  {
    return std::abs(x - point.X) <= radius && std::abs(y - point.Y) <= radius && (x != point.X || y != point.Y) &&
      there.count({ x, y }) > 0;
  };
  std::vector<double> alongX;
  std::vector<double> alongY;
  for (const auto& [place, height] : there)
  {
    const auto& [x, y] = place;
    if (isNear(x, y) && isNear(x + 1, y))
    {
      alongX.push_back(there.at({ x + 1, y }) - height);
    }
    if (isNear(x, y) && isNear(x, y + 1))
    {
      alongY.push_back(there.at({ x, y + 1 }) - height);
    }
  }
  const double dipX = alongX.empty() ? 0.0 : MedianOf(alongX);
  const double dipY = alongY.empty() ? 0.0 : MedianOf(alongY);
  std::vector<double> around;
  for (const auto& [place, height] : there)
  {
    if (isNear(place.first, place.second))
    {
      around.push_back(height - dipX * (place.first - point.X) - dipY * (place.second - point.Y));
    }
  }
  return around.size() < 3 ? 0.0 : there.at({ point.X, point.Y }) - MedianOf(around);
}

void TestRandomPatches()
{
  Patches::Random random(23);
  for (int n = 0; n < 200; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    std::map<std::pair<int, int>, double> there;
    std::vector<double> heights;
    for (const PlanePoint& column : columns)
    {
      heights.push_back(std::floor(10.0 * random.Fraction()));
      there[{ column.X, column.Y }] = heights.back();
    }
    const DespikingOptions options = { 0.25 + double(n % 4), 1 + n % 3, n % 5 };
    const Kinds kinds = FindSpikes(columns, heights, options).Kind;
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      const bool isSpike = std::abs(DeviationOf(there, columns[point], options.Radius)) > options.Threshold;
      const bool isSpur =
        options.SpurWidth > 0 && !IsCovered(there, columns[point].X, columns[point].Y, options.SpurWidth + 1);
      CHECK(kinds[point] == (isSpike ? SpikeKind::Spike : isSpur ? SpikeKind::Spur : SpikeKind::None));
    }
  }
}

/// Of nearly normal deviation 1: the sum of twelve even ones.
double Normal(Patches::Random& random)
{
  double sum = -6.0;
  for (int n = 0; n < 12; ++n)
  {
    sum += random.Fraction();
  }
  return sum;
}

/// At the rim points are on one side only: a dip of 5 is no spike there, and a spike of 3 is found.
void TestRimOfADip()
{
  const Patches::Columns columns = Rectangle(20, 20);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(5.0 * column.X - 5.0 * column.Y);
  }
  const DespikingOptions two = { 2.0, 2, 0 };
  CHECK_EQUAL(Count(FindSpikes(columns, heights, two).Kind, SpikeKind::Spike), 0u);
  for (const std::size_t spike : { 0, 10, 19, 200, 399 })
  {
    heights[spike] += 3.0;
    const Kinds kinds = FindSpikes(columns, heights, two).Kind;
    CHECK(kinds[spike] == SpikeKind::Spike);
    CHECK_EQUAL(Count(kinds, SpikeKind::Spike), 1u);
    heights[spike] -= 3.0;
  }
}

/// The threshold is four times the noise, whatever the dip, and follows the unit.
void TestThresholdByNoise()
{
  const Patches::Columns columns = Rectangle(200, 150);
  Patches::Random random(3);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(3.0 * column.X - 7.0 * column.Y + 0.5 * Normal(random));
  }
  const std::vector<std::size_t> spikes = { 0, 57, 5000, 12345, 29999 };
  for (const std::size_t spike : spikes)
  {
    heights[spike] += spike % 2 == 0 ? 8.0 : -8.0;
  }
  const Spikes found = FindSpikes(columns, heights, {});
  CHECK(found.Threshold > 1.9 && found.Threshold < 2.3);
  for (const std::size_t spike : spikes)
  {
    CHECK(found.Kind[spike] == SpikeKind::Spike);
  }
  CHECK(Count(found.Kind, SpikeKind::Spike) < spikes.size() + 5u);
  CHECK(MeasureNoise(columns, heights) == found.Threshold / 4.0);
  std::vector<double> scaled;
  for (const double height : heights)
  {
    scaled.push_back(0.25 * height); // exactly
  }
  const Spikes same = FindSpikes(columns, scaled, {});
  CHECK(same.Kind == found.Kind);
  CHECK_EQUAL(same.Threshold, 0.25 * found.Threshold);
}

/// Terrain is compared with itself: a rough half does not hide the spikes of the smooth one, and is not taken for them.
void TestRoughAndSmooth()
{
  const Patches::Columns columns = Rectangle(200, 200);
  Patches::Random random(5);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back((column.X < 150 ? 0.2 : 4.0) * Normal(random));
  }
  heights[100 * 200 + 50] += 20.0;
  const Kinds kinds = FindSpikes(columns, heights, {}).Kind;
  CHECK(kinds[100 * 200 + 50] == SpikeKind::Spike);
  CHECK(Count(kinds, SpikeKind::Spike) < columns.size() / 50);
}

/// What rounding does to differences of whole heights is the least noise: nothing of a plane is a spike.
void TestNoiseOfRounding()
{
  const Patches::Columns columns = Rectangle(40, 30);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(std::round(0.3 * column.X + 0.7 * column.Y));
  }
  const Spikes whole = FindSpikes(columns, heights, {});
  CHECK(whole.Threshold >= 4.0 / std::sqrt(6.0));
  CHECK_EQUAL(Count(whole.Kind, SpikeKind::Spike), 0u);
  const std::vector<double> level(columns.size(), 1000.0);
  CHECK_EQUAL(Count(FindSpikes(columns, level, {}).Kind, SpikeKind::Spike), 0u);
  CHECK_EQUAL(MeasureNoise({}, {}), 0.0);
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
  const Kinds one = FindSpikes(columns, heights, Four).Kind;
  Detail::NumberOfThreads() = 3;
  CHECK(FindSpikes(columns, heights, Four).Kind == one);
  Detail::NumberOfThreads() = 2;
  CHECK_EQUAL(MonitorChecker::Check(1, [&](const Monitor& monitor) { FindSpikes(columns, heights, Four, monitor); }),
    std::string());
}

void TestErrors()
{
  const Patches::Columns columns = { { 0, 0 } };
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { -1.0, 2, 0 }), "threshold -1, expected at least 0 lattice units");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { infinity, 2, 0 }), "threshold inf, expected a finite number");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { 4.0, 0, 0 }), "neighborhood radius 0, expected 1 to 16 columns");
  CHECK_THROWS_WITH(FindSpikes(columns, { 0.0 }, { 4.0, 2, -1 }), "spur width -1, expected 0 to 64 columns");
  CHECK_THROWS_WITH(FindSpikes({ { 1, 1 }, { 1, 1 } }, { 0.0, 0.0 }, {}), "points 0 and 1 both in column (1, 1)");
}
}

int TestDespiking(int, char*[])
{
  TestSpikes();
  TestThreshold();
  TestFaultsAndLonePoints();
  TestSpurs();
  TestRimOfADip();
  TestThresholdByNoise();
  TestRoughAndSmooth();
  TestNoiseOfRounding();
  TestRandomPatches();
  TestThreadsOfTheComputerAndMonitor();
  TestErrors();
  return Check::Result();
}
