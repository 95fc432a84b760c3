// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that follow picks: on small cubes to the pick, and on cubes whose reflectors are known.

#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/GuideScore.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace PickFixtures;

namespace
{
/// Two flat layers, at samples 10 and 25, the upper one positive and the lower one negative.
Traces TwoLayers(const std::array<int, 3>& size = { 40, 30, 40 })
{
  Traces traces = Empty(size);
  for (int n = 0; n < size[0] * size[1]; ++n)
  {
    Put(traces.Trace(n % size[0], n / size[0]), 10, 1.0F);
    Put(traces.Trace(n % size[0], n / size[0]), 25, -2.0F);
  }
  return traces;
}

std::map<int, int> CountOrigins(const LatticeHorizon& surface)
{
  std::map<int, int> counts;
  for (const int origin : surface.Labels.at(0).second)
  {
    ++counts[origin];
  }
  return counts;
}

/// Each guide gives its layer whole, in the order of guides, whatever that of energies; origins and distances are
/// exact.
void TestLayers()
{
  const Traces traces = TwoLayers();
  const Extraction found =
    Follow(traces, { { "upper", { { 5, 7, 10.9 } } }, { "lower", { { 0, 0, 25.0 }, { 39, 29, 24.0 } } } });
  CHECK_EQUAL(found.Surfaces.size(), 2u);
  for (const std::size_t n : { 0U, 1U })
  {
    const LatticeHorizon& surface = found.Surfaces[n];
    CHECK_EQUAL(surface.Column.size(), 1200u);
    CHECK(std::all_of(surface.K.begin(), surface.K.end(), [n](int k) { return k == (n == 0 ? 10 : 25); }));
    CHECK_EQUAL(surface.Labels[0].first, "Origin");
    CHECK_EQUAL(surface.Attributes[2].first, "GuideDistance");
    CHECK_EQUAL(CountOrigins(surface)[0], n == 0 ? 1 : 2);
    CHECK_EQUAL(CountOrigins(surface)[1], n == 0 ? 1199 : 1198);
    CHECK_EQUAL(found.Guides[n].IsNegative, n == 1);
    CHECK(found.Guides[n].NearNone.empty() && found.Guides[n].Strays.empty());
  }
  for (std::size_t n = 0; n < 1200; ++n)
  {
    const PlanePoint& column = found.Surfaces[0].Column[n];
    CHECK_EQUAL(found.Surfaces[0].Attributes[2].second[n], std::max(std::abs(column.X - 5), std::abs(column.Y - 7)));
  }
}

/// A part is taken, and not grown; without growth a hole with nothing in it stays, and so does what is beyond.
void TestReach()
{
  Traces traces = TwoLayers();
  for (int j = 0; j < 30; ++j)
  {
    for (int i = 20; i < 22; ++i)
    {
      std::fill_n(traces.Trace(i, j), 40, 0.0F); // two dead lines: nothing links both sides
    }
  }
  const std::vector<Guide> guides = { { "upper", { { 5, 7, 10.0 } } } };
  CHECK_EQUAL(Follow(traces, guides).Surfaces[0].Column.size(), 600u);
  const std::vector<Guide> both = { { "upper", { { 5, 7, 10.0 }, { 30, 7, 10.0 } } } };
  CHECK_EQUAL(Follow(traces, both).Surfaces[0].Column.size(), 1140u);

  // One trace alone is no part: it grows as far as it may.
  ExtractionOptions options;
  const Traces small = TwoLayers({ 5, 5, 40 });
  CHECK_EQUAL(CountOrigins(Follow(small, { { "upper", { { 0, 0, 10.0 } } } }, options).Surfaces[0])[2], 24);
  options.Guidance.GrowthReach = 2;
  CHECK_EQUAL(CountOrigins(Follow(small, { { "upper", { { 0, 0, 10.0 } } } }, options).Surfaces[0])[2], 8);
  CHECK_EQUAL(Follow(small, { { "upper", { { 0, 0, 10.0 } } } }, options).Guides[0].Stopped, 7);
  options.Guidance.GrowthReach = 0;
  CHECK_EQUAL(Follow(small, { { "upper", { { 0, 0, 10.0 } } } }, options).Surfaces[0].Column.size(), 1u);
}

/// Two guides of one event both have it whole, and others are what neither has.
void TestSharing()
{
  const Traces traces = TwoLayers();
  ExtractionOptions options;
  options.Guidance.KeepOthers = true;
  const Extraction found = Follow(traces, { { "one", { { 5, 7, 10.0 } } }, { "two", { { 20, 20, 10.0 } } } }, options);
  CHECK_EQUAL(found.Surfaces.size(), 3u);
  for (const std::size_t n : { 0U, 1U })
  {
    CHECK_EQUAL(found.Surfaces[n].Column.size(), 1200u);
    CHECK_EQUAL(found.Guides[n].Shared, 1200);
    CHECK_EQUAL(found.Guides[n].SharedWith, 1 - n);
    CHECK_EQUAL(found.Guides[n].Seams, 0);
    CHECK_EQUAL(CountOrigins(found.Surfaces[n])[0], 1);
  }
  CHECK_EQUAL(found.Surfaces[2].Column.size(), 1200u);
  CHECK_EQUAL(found.Surfaces[2].K[0], 25);
  CHECK_EQUAL(found.NumberOfSurfaces, 1);
}

/// A fault puts the upper layer beside the lower one, which has a shadow below. Growth of the lower layer's guide leaks
/// into the upper layer, whose own guide has a pick there.
void TestLeak()
{
  constexpr int fault = 30;
  Traces traces = Empty({ 60, 30, 90 });
  for (int n = 0; n < 1800; ++n)
  {
    const int i = n % 60;
    const int down = i < fault ? 0 : 20;
    Put(traces.Trace(i, n / 60), 20 + down, 2.0F);
    Put(traces.Trace(i, n / 60), 40 + down, 2.0F);
    Put(traces.Trace(i, n / 60), 46 + down, -1.5F);
  }
  const Guide lower = { "lower", { { 5, 5, 40 } } };
  CHECK_EQUAL(Follow(traces, { lower }).Surfaces[0].Column.size(), 1800u);
  const Extraction found = Follow(traces, { lower, { "upper", { { 10, 10, 20 }, { 40, 20, 40 } } } });
  CHECK_EQUAL(found.Surfaces[1].Column.size(), 1800u);
  const auto& columns = found.Surfaces[0].Column;
  CHECK_EQUAL(
    std::count_if(columns.begin(), columns.end(), [](const PlanePoint& column) { return column.X < fault; }), 900);
  CHECK(columns.size() <= 30U * (fault + 8));
}

/// Two layers pinch out to one event: both guides have it, with their own picks, in any order of three guides.
void TestPinchOut()
{
  Traces traces = Empty({ 60, 30, 60 });
  for (int n = 0; n < 1800; ++n)
  {
    const int i = n % 60;
    Put(traces.Trace(i, n / 60), 20, 2.0F);
    Put(traces.Trace(i, n / 60), std::max(20, 32 - i / 3), 2.0F);
    Put(traces.Trace(i, n / 60), 50, -2.0F);
  }
  const std::vector<Guide> guides = { { "top", { { 3, 3, 20 }, { 50, 5, 20 }, { 55, 25, 20 } } },
    { "base", { { 2, 20, 32 }, { 52, 15, 20 }, { 57, 8, 20 } } }, { "deep", { { 30, 9, 50 } } } };
  std::array<std::size_t, 3> order = { 0, 1, 2 };
  const Extraction first = Follow(traces, guides);
  CHECK(first.Guides[0].Shared > 300 && first.Guides[0].Shared == first.Guides[1].Shared);
  while (std::next_permutation(order.begin(), order.end()))
  {
    const Extraction found = Follow(traces, { guides[order[0]], guides[order[1]], guides[order[2]] });
    for (std::size_t n = 0; n < 3; ++n)
    {
      CHECK(found.Surfaces[n].Column == first.Surfaces[order[n]].Column);
      CHECK(found.Surfaces[n].RealZ == first.Surfaces[order[n]].RealZ);
      CHECK(found.Surfaces[n].Attributes == first.Surfaces[order[n]].Attributes);
      CHECK(found.Surfaces[n].Labels == first.Surfaces[order[n]].Labels);
      CHECK_EQUAL(CountOrigins(found.Surfaces[n])[0], int(guides[order[n]].Picks.size()));
    }
  }
}

bool AreEqual(const Extraction& a, const Extraction& b)
{
  return std::equal(a.Surfaces.begin(), a.Surfaces.end(), b.Surfaces.begin(), b.Surfaces.end(),
    [](const LatticeHorizon& one, const LatticeHorizon& other)
    {
      return one.Column == other.Column && one.RealZ == other.RealZ && one.Attributes == other.Attributes &&
        one.Labels[0] == other.Labels[0] && one.Labels[1] == other.Labels[1]; // Seed depends on the order of picks.
    });
}

/// On any number of threads, and in any order of the picks and of guides.
void TestOrder()
{
  CubeGeneratorOptions options = HardCube(3);
  options.NoiseFraction = 0.4;
  const CubeGenerator cube(options);
  const Traces traces = Generate(options);
  std::vector<Guide> guides = MakeGuides(cube, { 3, 1.0, 0.0 }, 5);
  guides.erase(
    std::remove_if(guides.begin(), guides.end(), [](const Guide& guide) { return guide.Picks.empty(); }), guides.end());
  const auto [one, three] = OnThreads([&]() { return Follow(traces, guides); });
  CHECK(one.Surfaces.size() > 4u && AreEqual(one, three));
  std::vector<Guide> turned = guides;
  for (Guide& guide : turned)
  {
    std::reverse(guide.Picks.begin(), guide.Picks.end());
  }
  CHECK(AreEqual(one, Follow(traces, turned)));
  for (const std::size_t n : { std::size_t(0), guides.size() - 1 })
  {
    const Extraction alone = Follow(traces, { guides[n] });
    CHECK(alone.Surfaces[0].Column == one.Surfaces[n].Column && alone.Surfaces[0].RealZ == one.Surfaces[n].RealZ);
  }
}

/// The score itself, of surfaces that are made of the true places: counted by hand.
void TestScore()
{
  CubeGeneratorOptions options = WildCube(9);
  const CubeGenerator cube(options);
  const double period = 1000.0 / (options.Frequency * options.SampleInterval);
  std::vector<LatticeHorizon> surfaces(std::size_t(cube.Truth().Size()));
  std::int64_t places = 0;
  std::int64_t quarter = 0; // every fourth place of the first reflector
  std::int64_t absent = 0;
  for (int reflector = 0; reflector < cube.Truth().Size(); ++reflector)
  {
    LatticeHorizon& surface = surfaces[std::size_t(reflector)];
    for (int n = 0; n < options.Size[0] * options.Size[1]; ++n)
    {
      const PlanePoint column = { n % options.Size[0], n / options.Size[0] };
      const bool isThere = !cube.Truth().IsDead(column.X, column.Y) && !cube.Truth().IsMissing(column.X, column.Y);
      const double place =
        isThere ? cube.Truth().Place(reflector, column.X, column.Y) : std::numeric_limits<double>::quiet_NaN();
      surface.Column.push_back(column);
      const bool isQuarter = reflector == 0 && !std::isnan(place) && places % 4 == 0;
      surface.RealZ.push_back(std::isnan(place) ? 1.0 : isQuarter ? place + 0.51 * period : place + 0.24 * period);
      places += std::isnan(place) ? 0 : 1;
      quarter += isQuarter ? 1 : 0;
      absent += std::isnan(place) ? 1 : 0;
    }
  }
  const GuideScore score = ScoreGuided(cube, surfaces);
  CHECK_EQUAL(score.PresentPicks, places);
  CHECK_EQUAL(score.OffPicks, quarter);
  CHECK_EQUAL(score.AbsentPicks, absent);
  CHECK(absent > 0 && quarter > 0);
  CHECK(score.TruePlaces <= places && score.TruePlaces > 0.95 * double(places)); // parts below 100 columns do not count
  CHECK(score.FoundPlaces < score.TruePlaces && score.FoundPlaces >= score.TruePlaces - quarter);
  CHECK(std::abs(score.Weakest - 0.75) < 0.01);
}

/// On a wild cube with noise of a fifth of the signal.
void TestWildCube()
{
  CubeGeneratorOptions options = WildCube(9);
  options.NoiseFraction = 0.2;
  options.Noise = NoiseKind::Mixed;
  const CubeGenerator cube(options);
  const Traces traces = Generate(options);
  std::vector<Guide> guides = MakeGuides(cube, { 5, 0.0, 0.0 }, 9);
  CHECK(std::none_of(guides.begin(), guides.end(), [](const Guide& guide) { return guide.Picks.empty(); }));
  const GuideScore guided = ScoreGuided(cube, Follow(traces, guides).Surfaces);
  ExtractionOptions all;
  all.SmallestSize = 10;
  all.LargestNumber = 100000;
  const std::vector<LatticeHorizon> surfaces = ExtractReflections(traces.View(), all).Surfaces;
  const GuideScore unguided = ScoreUnguided(cube, surfaces);
  CHECK(guided.Found() > 0.93);
  CHECK(guided.Found() > unguided.Found() + 0.02);
  CHECK(guided.Off() < 0.02);
  CHECK(guided.Absent() < 0.1);
  CHECK(CountMain(cube, surfaces, 20) >= 18);
}

/// The strongest surface comes first, or the largest one.
void TestSurfaceOrder()
{
  Traces traces = Empty({ 10, 10, 40 });
  for (int n = 0; n < 100; ++n)
  {
    Put(traces.Trace(n % 10, n / 10), 10, 1.0F);
    if (n < 50)
    {
      Put(traces.Trace(n % 10, n / 10), 25, 2.0F);
    }
  }
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.Reflections.AmplitudePercentile = 0.0;
  CHECK_EQUAL(ExtractReflections(traces.View(), options).Surfaces[0].K[0], 25); // 50 x 64 beside 100 x 8
  options.Order = SurfaceOrder::Size;
  CHECK_EQUAL(ExtractReflections(traces.View(), options).Surfaces[0].K[0], 10);
}

/// Horizons are followed on both signs where polarity turns, and on one where picks miss their reflections.
void TestPolarity()
{
  CubeGeneratorOptions options = WildCube(9);
  options.Size = { 70, 60, 200 };
  for (const bool turns : { true, false })
  {
    options.Troubles = turns ? std::set<Trouble>{ Trouble::Polarity } : std::set<Trouble>();
    const CubeGenerator generator(options);
    const std::vector<Guide> guides = MakeGuides(generator, { 20, turns ? 0.0 : 2.0, 0.0 }, 1);
    const Extraction extraction = ExtractReflections(Generate(options).View(), ExtractionOptions(), Monitor(), guides);
    const auto turned = std::count_if(
      extraction.Guides.begin(), extraction.Guides.end(), [](const GuideUse& use) { return use.Turned > 0; });
    const GuideScore score = ScoreGuided(generator, extraction.Surfaces);
    CHECK(turns ? 2 * turned > std::ptrdiff_t(guides.size()) : turned == 0);
    CHECK(score.Found() > (turns ? 0.85 : 0.9));
    CHECK(score.Off() < 0.05);
  }
}

void TestErrors()
{
  const Traces traces = TwoLayers();
  const auto refuse = [&](const Guide& guide, const std::string& message)
  { CHECK_THROWS_WITH(Follow(traces, { guide }), message); };
  refuse({ "top", {} }, "guide \"top\": no picks, expected one or more");
  refuse({ "top", { { 5, 5, 10 }, { 40, 5, 10 } } },
    "guide \"top\": pick 2 at column 40, row 5, sample 10, is outside of the cube, which has 40 columns, 30 rows and "
    "40");
  refuse({ "top", { { 5, 5, 39.5 } } }, "is outside of the cube");
  refuse({ "top", { { 5, 5, std::nan("") } } }, "is outside of the cube");
  refuse({ "top", { { 5, 5, 17 }, { 6, 6, 32 } } }, "none of 2 picks is within 1.5 samples of a strong reflection");
  refuse({ "top", { { 5, 5, 10 }, { 5, 5, 25 } } },
    "two picks in one column, at column 5, row 5, sample 10 and 25, expected");
  ExtractionOptions options;
  options.Joining = SurfaceJoining::Components;
  CHECK_THROWS_WITH(Follow(traces, { { "top", { { 5, 5, 10 } } } }, options), "guides and Joining Components");
  options = {};
  options.Guidance.GrowthReach = -1;
  CHECK_THROWS_WITH(Follow(traces, {}, options), "GrowthReach -1, expected at least 0 columns");
  options = {};
  options.Guidance.GrowthCorrelation = 1.5;
  CHECK_THROWS_WITH(Follow(traces, {}, options), "GrowthCorrelation 1.5, expected 0 to 1");
  options = {};
  options.Guidance.Tolerance = -0.5;
  CHECK_THROWS_WITH(Follow(traces, {}, options), "GuideTolerance -0.5, expected 0 to 262143 samples");
}

void TestMonitor()
{
  const Traces traces = TwoLayers();
  CHECK_EQUAL(MonitorChecker::Check(4,
                [&](const Monitor& monitor) {
                  ExtractReflections(traces.View(), {}, monitor, { { "top", { { 5, 5, 10 } } } });
                }),
    "");
}
}

int TestGuides(int, char*[])
{
  TestLayers();
  TestReach();
  TestSharing();
  TestLeak();
  TestPinchOut();
  TestOrder();
  TestScore();
  TestWildCube();
  TestSurfaceOrder();
  TestPolarity();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
