// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stacks with known layers, what must not matter to them, and every message.

#include "Common/Base/Parallel.h"
#include "DomainChecker.h"
#include "LayerChecker.h"
#include "RandomStacks.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace SeismicHorizons;
using LayerChecker::Horizon;

namespace
{
template <typename Height>
Horizon Make(int width, int height, Height&& heightAt)
{
  Horizon horizon;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      horizon.Columns.push_back({ x, y });
      horizon.Heights.push_back(heightAt(x, y));
    }
  }
  return horizon;
}

Layers MakeFrom(const std::vector<Horizon>& horizons, const LayerOptions& options = LayerOptions())
{
  return MakeLayers(LayerChecker::ViewsOf(horizons), options);
}

/// Two planes and one above them: two triangles, six wedges' corners, and volumes to the last digit.
void TestPlanes()
{
  const std::vector<Horizon> horizons = { Make(9, 5, [](int x, int) { return 6.0 + x; }),
    Make(9, 5, [](int x, int y) { return 2.0 + 0.5 * x - 0.25 * y; }), Make(9, 5, [](int, int) { return 0.0; }) };
  const Layers layers = MakeFrom(horizons);
  CHECK_EQUAL(layers.Plan.Columns.size(), std::size_t(4));
  CHECK_EQUAL(layers.Plan.NumberOfTriangles(), std::size_t(2));
  CHECK_EQUAL(layers.Ledgers.PointsOutside[0], 0);
  const LayerVolume upper = MeasureLayer(layers.Plan, 0);
  CHECK_EQUAL(upper.Area, 32.0);
  CHECK_EQUAL(upper.Volume, 32.0 * (4.0 + 0.5 * 4.0 + 0.25 * 2.0));
  CHECK_EQUAL(upper.LeastThickness, 4.0);
  CHECK_EQUAL(upper.LargestThickness, 9.0);
  CHECK_EQUAL(MeasureLayer(layers.Plan, 1).MeanThickness, 2.0 + 0.5 * 4.0 - 0.25 * 2.0);
  CHECK_EQUAL(MakeLayerCells(layers.Plan).Size(), std::size_t(4));
  CHECK_EQUAL(MakeLayerCells(layers.Plan).Vertices.size(), std::size_t(12));
  CHECK_EQUAL(VolumeAbove(layers.Plan, 1, 0.0), MeasureLayer(layers.Plan, 1).Volume);
}

/// A fill that ends against a slope at x = 20.25, thinner than the error far beyond that.
void TestPinchOutLine()
{
  const std::vector<Horizon> horizons = { Make(60, 40, [](int, int) { return 3.0; }),
    Make(60, 40, [](int x, int y) { return 3.0 + 0.04 * (x - 20.25) + 0.3 * std::sin(0.5 * y) * (x > 40 ? 1 : 0); }) };
  LayerOptions options;
  options.MaximumError = 1.0;
  options.Crossings.Policies = { CrossingPolicy::LowerWins };
  for (const DecimationEffort effort : { DecimationEffort::Fast, DecimationEffort::Best })
  {
    options.Effort = effort;
    options.PinchOutLines = false;
    const Layers without = MakeFrom(horizons, options);
    const auto [pinched, ghosts] = LayerChecker::Checker(horizons, without, options).CountGhosts(0);
    CHECK_EQUAL(pinched, 39 * 40);
    CHECK(ghosts > pinched / 4);
    options.PinchOutLines = true;
    const Layers with = MakeFrom(horizons, options);
    LayerChecker::Checker checker(horizons, with, options);
    CHECK_EQUAL(checker.Check(), std::string());
    CHECK_EQUAL(checker.CountGhosts(0)[1], 0);
    CHECK(with.PinchOutLines > 0);
    CHECK_EQUAL(with.LinesLeftOut, std::size_t(0));
    CHECK(MeasureLayer(with.Plan, 0).Triangles[0] > 0);
    options.SmallestPinch = pinched + 1;
    CHECK_EQUAL(MakeFrom(horizons, options).PinchOutLines, std::size_t(0));
    options.SmallestPinch = 25;
  }
}

/// The layer of two horizons that coincide all over has no cells, and no body.
void TestNoLayer()
{
  const auto wave = [](int x, int y) { return std::sin(0.4 * x) + 0.1 * y; };
  const std::vector<Horizon> horizons = { Make(20, 20, wave), Make(20, 20, wave),
    Make(20, 20, [](int, int) { return -5; }) };
  LayerOptions options;
  options.MaximumError = 0.2;
  const Layers layers = MakeFrom(horizons, options);
  LayerChecker::Checker checker(horizons, layers, options);
  CHECK_EQUAL(checker.Check(), std::string());
  CHECK_EQUAL(MeasureLayer(layers.Plan, 0).Volume, 0.0);
  CHECK_EQUAL(MakeLayerBody(layers.Plan, 0).Faces.size(), std::size_t(0));
  CHECK_EQUAL(checker.CountGhosts(0)[1], 0);
}

/// The upper layer ends at x = 10, the lower one begins at x = 5: between the two lines both share the middle horizon's
/// points.
void TestDomains()
{
  std::vector<Horizon> horizons = { Make(11, 9, [](int, int) { return 7.0; }),
    Make(21, 9, [](int x, int) { return 4.0 + 0.125 * x; }), Make(21, 9, [](int, int) { return 0.0; }) };
  horizons[2] = Make(16, 9, [](int, int) { return 0.0; });
  for (PlanePoint& column : horizons[2].Columns)
  {
    column.X += 5;
  }
  LayerOptions options;
  options.Domain = LayerDomain::EachLayer;
  for (const DecimationEffort effort : { DecimationEffort::Fast, DecimationEffort::Best })
  {
    options.Effort = effort;
    const Layers layers = MakeFrom(horizons, options);
    CHECK_EQUAL(LayerChecker::DomainChecker(horizons, layers, options).CheckDomains(), std::string());
    CHECK_EQUAL(layers.Plan.Columns.size(), std::size_t(8));
    CHECK_EQUAL(layers.Plan.NumberOfTriangles(), std::size_t(6));
    CHECK(std::abs(MeasureLayer(layers.Plan, 0).Volume - 190.0) < 1e-12 * 190.0);
    CHECK(std::abs(MeasureLayer(layers.Plan, 1).Volume - 667.5) < 1e-12 * 667.5);
    const LayerCells cells = MakeLayerCells(layers.Plan);
    CHECK_EQUAL(cells.Size(), std::size_t(4 + 4));
    CHECK_EQUAL(cells.Vertices.size(), std::size_t(6 + 8 + 6));
  }
  options.Domain = LayerDomain::Common;
  options.OutlineTolerance = 0.0;
  CHECK_EQUAL(MeasureLayer(MakeFrom(horizons, options).Plan, 0).Area, 40.0);
}

/// Points in any order, on any number of threads.
void TestWhatDoesNotMatter()
{
  RandomStacks::Stack stack = RandomStacks::Generator(4).Run();
  Horizon large = Make(150, 120, [](int x, int y) { return 4.0 * std::sin(0.1 * x) + 3.0 * std::cos(0.13 * y); });
  stack.Horizons = { large, large, large };
  std::mt19937 random(3);
  for (std::size_t n = 0; n < 3; ++n)
  {
    for (double& height : stack.Horizons[n].Heights)
    {
      height += double(random() % 1000) / 1000.0 - double(n);
    }
  }
  stack.Options = LayerOptions();
  const Layers one = MakeFrom(stack.Horizons, stack.Options);
  const auto isSame = [&one](const Layers& other)
  {
    return std::equal(one.Plan.Triangles.begin(), one.Plan.Triangles.end(), other.Plan.Triangles.begin(),
             other.Plan.Triangles.end()) &&
      one.Plan.Heights == other.Plan.Heights && one.Plan.Columns == other.Plan.Columns;
  };
  CHECK(one.Plan.NumberOfTriangles() > 100);
  Detail::NumberOfThreads() = 3;
  CHECK(isSame(MakeFrom(stack.Horizons, stack.Options)));
  Detail::NumberOfThreads() = 1;
  for (Horizon& horizon : stack.Horizons)
  {
    std::vector<std::size_t> order(horizon.Columns.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    const Horizon before = horizon;
    for (std::size_t n = 0; n < order.size(); ++n)
    {
      horizon.Columns[n] = before.Columns[order[n]];
      horizon.Heights[n] = before.Heights[order[n]];
    }
  }
  CHECK(isSame(MakeFrom(stack.Horizons, stack.Options)));
}

/// Upside down, and with the horizons in reverse order, the same layers.
void TestDepths()
{
  RandomStacks::Stack stack = RandomStacks::Generator(11).Run();
  const auto height = [](double phase)
  { return [phase](int x, int y) { return 5.0 * std::sin(0.2 * x + phase) + 0.1 * y; }; };
  std::vector<Horizon> horizons = { Make(40, 30, height(0.0)), Make(40, 30, height(0.4)), Make(40, 30, height(0.9)) };
  LayerOptions options;
  options.Crossings.Policies = { CrossingPolicy::UpperWins, CrossingPolicy::Mean };
  const Layers heights = MakeFrom(horizons, options);
  for (Horizon& horizon : horizons)
  {
    std::transform(horizon.Heights.begin(), horizon.Heights.end(), horizon.Heights.begin(), std::negate<>());
  }
  options.Crossings.HeightsGrowDownwards = true;
  const Layers depths = MakeFrom(horizons, options);
  for (std::size_t layer = 0; layer < 2; ++layer)
  {
    const double volume = MeasureLayer(heights.Plan, layer).Volume;
    CHECK(volume > 100.0);
    CHECK(std::abs(MeasureLayer(depths.Plan, layer).Volume - volume) < 1e-9 * volume);
    CHECK(std::abs(VolumeAbove(depths.Plan, layer, -1.0) - VolumeAbove(heights.Plan, layer, 1.0)) < 1e-9 * volume);
  }
}

void TestOrder()
{
  std::vector<Horizon> horizons = { Make(6, 3, [](int, int) { return 1.0; }),
    Make(6, 3, [](int x, int) { return 5.0 * x - 2.0; }), Make(6, 3, [](int, int) { return 2.0; }) };
  CrossingOptions options;
  const auto order = [&]() { return OrderByHeight(LayerChecker::ViewsOf(horizons), options); };
  CHECK((order() == std::vector<std::size_t>{ 1, 2, 0 }));
  options.HeightsGrowDownwards = true;
  CHECK((order() == std::vector<std::size_t>{ 0, 2, 1 }));
  options.Names = { "Top", "Tilted", "Base" };
  horizons[1] = Make(6, 3, [](int x, int) { return 5.0 * x - 7.0; });
  CHECK_THROWS_WITH(order(), "Base is above Tilted in 67 % of their columns and below in 33 %, expected an order");
  horizons[2].Columns.clear();
  CHECK_THROWS_WITH(order(), "Top and Base have no column in common, expected horizons");
}

void TestMessages()
{
  const Horizon level = Make(4, 4, [](int, int) { return 1.0; });
  Horizon beside = level;
  for (PlanePoint& column : beside.Columns)
  {
    column.X += 4;
  }
  Horizon broken = level;
  broken.Heights[5] = std::numeric_limits<double>::quiet_NaN();
  Horizon twice = level;
  twice.Columns[3] = twice.Columns[2];
  Horizon corner = level; // has a column in common with each of two that have none with each other
  corner.Columns[0] = { 7, 3 };
  Horizon high = Make(4, 4, [](int, int) { return 2.5; });
  LayerOptions options;
  CHECK_THROWS_WITH(MakeFrom({}), "no horizon, expected at least 2");
  CHECK_THROWS_WITH(MakeFrom({ level }), "one horizon, expected at least 2");
  CHECK_THROWS_WITH(MakeFrom({ level, beside }), "horizon 1 and horizon 2 have no column in common, expected");
  CHECK_THROWS_WITH(MakeFrom({ level, corner, beside }), "horizon 1 and horizon 3 have no column in common, expected");
  CHECK_THROWS_WITH(MakeFrom({ level, broken }), "horizon 2: point 5 without a height, expected a finite number");
  CHECK_THROWS_WITH(MakeFrom({ level, twice }), "points 2 and 3 both in column (2, 0)");
  options.Crossings.Policies = { CrossingPolicy::Stop };
  CHECK_THROWS_WITH(
    MakeFrom({ level, high }, options), "cross in 16 columns, by up to 1.5 lattice units, expected none");
  options = LayerOptions();
  options.MaximumError = -1.0;
  CHECK_THROWS_WITH(MakeFrom({ high, level }, options), "maximum error -1, expected at least 0");
  options = LayerOptions();
  options.OutlineTolerance = -1.0;
  CHECK_THROWS_WITH(MakeFrom({ high, level }, options), "outline tolerance -1, expected at least 0");
  options = LayerOptions();
  options.SmallestAngle = 61.0;
  CHECK_THROWS_WITH(MakeFrom({ high, level }, options), "smallest angle 61, expected 0 to 60 degrees");
  options = LayerOptions();
  options.Domain = LayerDomain::EachLayer;
  options.OutlineTolerance = 0.5;
  CHECK_THROWS_WITH(MakeFrom({ high, level }, options), "where each layer has a domain of its own, expected a radius");
  options.OutlineTolerance.reset();
  CHECK_THROWS_WITH(MakeFrom({ high, beside }, options), "horizon 1 and horizon 2 have no column in common, expected");
  options = LayerOptions();
  options.SmallestPinch = 0;
  CHECK_THROWS_WITH(MakeFrom({ high, level }, options), "smallest pinch-out 0, expected at least 1");
}

/// Points in a row have no area: nothing is made, and all of them are outside.
void TestNoArea()
{
  const Layers layers =
    MakeFrom({ Make(9, 1, [](int, int) { return 2.0; }), Make(9, 1, [](int, int) { return 1.0; }) });
  CHECK_EQUAL(layers.Plan.NumberOfTriangles(), std::size_t(0));
  CHECK_EQUAL(layers.Ledgers.PointsOutside[0], 9);
  CHECK_EQUAL(MakeLayerCells(layers.Plan).Size(), std::size_t(0));
  CHECK_EQUAL(MeasureLayer(layers.Plan, 0).Volume, 0.0);
}

void TestMonitor()
{
  const std::vector<Horizon> horizons = { Make(60, 60, [](int x, int y) { return 9.0 + std::sin(0.3 * x) * y; }),
    Make(60, 60, [](int x, int y) { return 0.2 * x + std::cos(0.2 * y) * y; }) };
  const std::vector<HorizonView> views = LayerChecker::ViewsOf(horizons);
  CHECK_EQUAL(
    MonitorChecker::Check(20, [&views](const Monitor& monitor) { MakeLayers(views, LayerOptions(), monitor); }),
    std::string());
}
}

int TestLayers(int, char*[])
{
  TestPlanes();
  TestPinchOutLine();
  TestNoLayer();
  TestDomains();
  TestWhatDoesNotMatter();
  TestDepths();
  TestOrder();
  TestMessages();
  TestNoArea();
  TestMonitor();
  return Check::Result();
}
