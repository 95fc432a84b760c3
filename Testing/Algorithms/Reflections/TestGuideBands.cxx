// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Large cubes, of which only bands around guides are searched: the bands follow the reflector from one pick, and what is
// found is what the whole cube gives.

#include "Filters/Algorithms/Reflections/GuideBands.h"
#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/GuideScore.h"
#include "Tools/MonitorChecker.h"

#include <cmath>
#include <limits>

using namespace PickFixtures;

namespace
{
constexpr double Period = 10.0;
const BandOptions Usual{ 15, 3 };

/// Up to a quarter of a period from column to column.
double Folded(int i, int j)
{
  return 150.0 + 45.0 * std::sin(i / 18.0) + 35.0 * std::cos(j / 14.0);
}

/// Layers at uneven distances, each of them parallel to the folded one, with two columns of missing traces.
Traces FoldedLayers(const std::array<int, 3>& size)
{
  Traces traces = Empty(size);
  const std::vector<double> layers = { -110.0, -83.0, -62.0, -37.0, -24.0, 0.0, 17.0, 41.0, 54.0, 80.0, 103.0 };
  for (int n = 0; n < size[0] * size[1]; ++n)
  {
    const int i = n % size[0];
    const int j = n / size[0];
    for (int k = 0; k < size[2]; ++k)
    {
      float& sample = traces.Trace(i, j)[k];
      for (std::size_t layer = 0; layer < layers.size(); ++layer)
      {
        const double x = 3.14159265 * (k - Folded(i, j) - layers[layer]) / Period;
        sample += float((layer % 3 == 1 ? -1.0 : 1.0) * (1.0 - 2.0 * x * x) * std::exp(-x * x));
      }
      sample = i == 40 || i == 41 ? std::numeric_limits<float>::quiet_NaN() : sample;
    }
  }
  return traces;
}

void TestPaths()
{
  const Traces traces = FoldedLayers({ 90, 70, 300 });
  const Guide guide{ "One", { { 5, 60, Folded(5, 60) } } };
  const Guide other{ "Other", { { 80, 3, Folded(80, 3) + 41.0 } } };
  const auto [one, three] = OnThreads(
    [&]() {
      return FollowRoughly(traces.View(), { guide, other }, Usual, Monitor());
    });
  CHECK(one == three);
  for (int n = 0; n < 90 * 70; ++n)
  {
    const double place = Folded(n % 90, n / 90);
    // Beyond the gap, where paths are level, they may be on a layer nearby.
    CHECK(std::abs(one[0][n] - place) <= (n % 90 < 40 ? 1.0 : 1.5 * Period));
    CHECK(std::abs(one[1][n] - place - 41.0) <= (n % 90 > 41 ? 1.0 : 1.5 * Period));
  }
  CHECK_EQUAL(
    MonitorChecker::Check(2, [&](const Monitor& monitor) { FollowRoughly(traces.View(), { guide }, Usual, monitor); }),
    "");
}

/// Places outside of traces, traces of one sample, and cubes of one trace.
void TestEdges()
{
  const Traces flat = Empty({ 4, 3, 1 });
  CHECK_EQUAL(FollowRoughly(flat.View(), { { "A", { { 0, 0, 0.0 } } } }, Usual, Monitor())[0].size(), 12u);
  const Traces single = Rough({ 1, 1, 30 }, 3);
  CHECK_EQUAL(FollowRoughly(single.View(), { { "A", { { 0, 0, 29.0 } } } }, Usual, Monitor())[0][0], 29.0F);
}

/// Of each few rows one is chosen, that of a pick if there is one, and neither even nor odd ones alone.
void TestRows()
{
  const std::vector<int> rows = ChooseRows(1003, 10, { { "A", { { 0, 77, 1.0 }, { 0, 1002, 1.0 } } } });
  int odd = 0;
  for (std::size_t n = 0; n < rows.size(); ++n)
  {
    CHECK_EQUAL(rows[n] / 10, int(n));
    odd += rows[n] % 2;
  }
  CHECK_EQUAL(rows.size(), 101u);
  CHECK(rows[7] == 77 && rows[100] == 1002);
  CHECK(odd > 30 && odd < 70);
}

/// Scores each guide of a cube alone.
GuideScore Score(const CubeGenerator& cube, const Traces& traces, std::int64_t largestWhole)
{
  ExtractionOptions options;
  options.Guidance.LargestWhole = largestWhole;
  const std::vector<Guide> guides = MakeGuides(cube, PickPlan(), cube.Options().Seed);
  std::vector<LatticeHorizon> found(guides.size());
  for (std::size_t n = 0; n < guides.size(); ++n)
  {
    if (!guides[n].Picks.empty())
    {
      Extraction result = ExtractReflections(traces.View(), options, Monitor(), { guides[n] });
      CHECK_EQUAL(result.HalfBand > 0.0, largestWhole == 0);
      found[n] = std::move(result.Surfaces.at(0));
    }
  }
  return ScoreGuided(cube, found);
}

void TestLikeWhole()
{
  for (const double noise : { 0.0, 0.3 })
  {
    CubeGeneratorOptions wild = WildCube(4711);
    wild.Size = { 70, 60, 280 };
    wild.NoiseFraction = noise;
    wild.Noise = NoiseKind::Mixed;
    const CubeGenerator cube(wild);
    const Traces traces = Generate(wild);
    const GuideScore whole = Score(cube, traces, std::int64_t(1) << 40);
    const GuideScore near = Score(cube, traces, 0);
    CHECK(whole.TruePlaces > 10000);
    CHECK(near.Found() > whole.Found() - 0.015);
    CHECK(near.Off() < whole.Off() + 0.01);
  }
}

/// With limits, and with others kept, which need the whole cube.
void TestOptions()
{
  const Traces traces = FoldedLayers({ 90, 70, 300 });
  const std::vector<Guide> guides = { { "One", { { 5, 60, Folded(5, 60) } } } };
  TraceLimits limits;
  for (int n = 0; n < 90 * 70; ++n)
  {
    limits.First.push_back(n % 90 < 20 ? Folded(n % 90, n / 90) - 3.0 : std::numeric_limits<double>::quiet_NaN());
    limits.Last.push_back(300.0);
  }
  ExtractionOptions options;
  options.Guidance.LargestWhole = 0;
  const Extraction limited = ExtractReflections(traces.View(), options, Monitor(), guides, limits);
  CHECK_EQUAL(limited.Surfaces.at(0).Column.size(), 20u * 70u);
  options.Guidance.KeepOthers = true;
  std::shared_ptr<JoinedReflections> kept;
  const Extraction all = ExtractReflections(traces.View(), options, Monitor(), guides, TraceLimits(), &kept);
  CHECK(all.HalfBand == 0.0 && all.Surfaces.size() > 5 && kept);
  options.Guidance.KeepOthers = false;
  const Extraction near = ExtractReflections(traces.View(), options, Monitor(), guides, TraceLimits(), &kept);
  CHECK(near.HalfBand > 0.0 && !kept && near.Picks < all.Picks / 2);
}
}

int TestGuideBands(int, char*[])
{
  TestPaths();
  TestEdges();
  TestRows();
  TestLikeWhole();
  TestOptions();
  return Check::Result();
}
