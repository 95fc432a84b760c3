// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From cubes to surfaces: on cubes whose reflectors are known, for all ways of joining.

#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/ExtractionScore.h"
#include "Tools/MonitorChecker.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace PickFixtures;

namespace
{
constexpr std::array<SurfaceJoining, 2> AllJoinings = { SurfaceJoining::BestFirst, SurfaceJoining::Components };

ExtractionOptions With(SurfaceJoining joining)
{
  ExtractionOptions options;
  options.Joining = joining;
  options.Order = SurfaceOrder::Size;
  return options;
}

CubeGeneratorOptions SmallCube(double noise = 0.0)
{
  CubeGeneratorOptions options;
  options.Size = { 40, 30, 220 };
  options.NoiseFraction = noise;
  return options;
}

bool AreEqual(const LatticeHorizon& a, const LatticeHorizon& b)
{
  return a.SurfaceId == b.SurfaceId && a.Column == b.Column && a.K == b.K && a.Thickness == b.Thickness &&
    a.Amplitude == b.Amplitude && a.RealZ == b.RealZ && a.DroppedDuplicates == b.DroppedDuplicates;
}

/// What all surfaces are like: in their order, numbered, large enough, in the order of columns, one voxel in each.
void CheckSurfaces(const Extraction& extraction, const ExtractionOptions& options)
{
  std::size_t last = std::numeric_limits<std::size_t>::max();
  int number = 0;
  for (const LatticeHorizon& surface : extraction.Surfaces)
  {
    CHECK_EQUAL(surface.SurfaceId, ++number);
    CHECK(surface.Column.size() <= last);
    CHECK(std::int64_t(surface.Column.size()) >= options.SmallestSize);
    last = surface.Column.size();
    for (std::size_t n = 1; n < surface.Column.size(); ++n)
    {
      CHECK(std::make_pair(surface.Column[n - 1].Y, surface.Column[n - 1].X) <
        std::make_pair(surface.Column[n].Y, surface.Column[n].X));
    }
    for (std::size_t n = 0; n < surface.Column.size(); ++n)
    {
      CHECK(std::abs(surface.RealZ[n] - surface.K[n]) <= 0.5);
      CHECK((surface.Amplitude[n] < 0.0) == (surface.Amplitude[0] < 0.0));
      CHECK(surface.Thickness[n] >= 1.0);
    }
  }
  CHECK(number <= options.LargestNumber && number <= extraction.NumberOfSurfaces);
}

void TestThreads()
{
  const Traces traces = Generate(SmallCube(0.3));
  for (const SurfaceJoining joining : AllJoinings)
  {
    const auto [one, three] = OnThreads([&]() { return ExtractReflections(traces.View(), With(joining)); });
    CheckSurfaces(one, With(joining));
    CHECK(one.Surfaces.size() > (joining == SurfaceJoining::Components ? 0u : 3u));
    CHECK(std::equal(one.Surfaces.begin(), one.Surfaces.end(), three.Surfaces.begin(), three.Surfaces.end(), AreEqual));
    CHECK_EQUAL(one.MedianCorrelation, three.MedianCorrelation);
  }
}

/// Without noise all is found, nothing else, and within a thirtieth of a sample.
void TestEasyCube()
{
  CubeGeneratorOptions cube;
  const CubeGenerator generator(cube);
  const Traces traces = Generate(cube);
  const ExtractionScore score =
    ScoreExtraction(generator, ExtractReflections(traces.View(), With(SurfaceJoining::BestFirst)));
  CHECK(score.TruePlaces > 20000);
  CHECK(score.Found() > 0.999);
  CHECK_EQUAL(score.WrongPicks, 0);
  CHECK_EQUAL(score.LeakedPicks, 0);
  CHECK(score.ErrorPercentile(99.0) < 0.03);
}

/// With noise of half the signal nearly all is found, also of the weakest layer.
void TestNoise()
{
  CubeGeneratorOptions cube;
  cube.NoiseFraction = 0.5;
  cube.Seed = 4;
  const CubeGenerator generator(cube);
  const Traces traces = Generate(cube);
  const ExtractionScore score =
    ScoreExtraction(generator, ExtractReflections(traces.View(), With(SurfaceJoining::BestFirst)));
  CHECK(score.Found() > 0.97);
  CHECK(score.WeakestFound > 0.9);
  CHECK(score.Wrong() < 0.005);
}

/// Which sides of the fault a surface is on, 1.5 columns from it or more.
std::set<bool> SidesOf(const CubeGenerator& cube, const LatticeHorizon& surface)
{
  std::set<bool> sides;
  for (std::size_t n = 0; n < surface.Column.size(); ++n)
  {
    const double distance = cube.Truth().FaultDistance(surface.Column[n].X, surface.Column[n].Y, surface.RealZ[n]);
    if (std::abs(distance) >= 1.5)
    {
      sides.insert(distance > 0.0);
    }
  }
  return sides;
}

/// However finely traces are sampled, about as much is found in noise.
void TestSampling()
{
  std::vector<double> found;
  for (const double fineness : { 1.0, 2.0, 3.3 })
  {
    ExtractionScore score;
    for (const std::uint64_t seed : { 22, 23 })
    {
      CubeGeneratorOptions options = HardCube(seed);
      options.Size = { 50, 40, 220 };
      options = SampleFinely(options, fineness);
      options.NoiseFraction = 0.4;
      const Extraction extraction = ExtractReflections(Generate(options).View());
      score.Add(ScoreExtraction(CubeGenerator(options), extraction));
    }
    CHECK(score.Wrong() < 0.03);
    found.push_back(score.Found());
  }
  CHECK(found[1] > 0.95 * found[0] && found[2] > 0.95 * found[0]);
}

/// Amplitudes that are all positive, as those of unsigned bytes, have runs as long as traces: no sign of fine sampling.
void TestBias()
{
  for (const float bias : { 0.0F, 1.0F, 10.0F })
  {
    Traces traces = Generate(SmallCube(0.3));
    const float largest = *std::max_element(traces.Samples.begin(), traces.Samples.end());
    for (float& sample : traces.Samples)
    {
      sample += bias * largest;
    }
    const Extraction extraction = ExtractReflections(traces.View());
    CHECK_EQUAL(extraction.IsBiased, bias > 0.0F);
    CHECK_EQUAL(extraction.IsSmoothed, bias == 0.0F);
  }
}

/// Noise is seen, and smoothed, however little of the traces is left by limits or by a mute.
void TestLittleLeft()
{
  CubeGeneratorOptions cube = SmallCube(0.5);
  Traces traces = Generate(cube);
  CHECK(ExtractReflections(traces.View()).IsSmoothed);
  const std::size_t columns = std::size_t(cube.Size[0]) * std::size_t(cube.Size[1]);
  const TraceLimits limits{ std::vector<double>(columns, 100.0), std::vector<double>(columns, 150.0), {}, 0.0 };
  CHECK(ExtractReflections(traces.View(), ExtractionOptions(), Monitor(), {}, limits).IsSmoothed);
  for (std::size_t sample = 0; sample < traces.Samples.size(); ++sample)
  {
    const std::size_t depth = sample % std::size_t(cube.Size[2]);
    traces.Samples[sample] = depth >= 100 && depth <= 150 ? traces.Samples[sample] : 0.0F;
  }
  CHECK(ExtractReflections(traces.View()).IsSmoothed);
  CHECK(!ExtractReflections(Generate(SmallCube()).View()).IsSmoothed);
}

/// No surface crosses a fault whose throw is above the largest step, on cubes without noise.
void TestFault()
{
  for (const double faultThrow : { 6.0, 12.0, 20.0 })
  {
    CubeGeneratorOptions cube;
    cube.FaultThrow = faultThrow;
    cube.Seed = std::uint64_t(faultThrow);
    const CubeGenerator generator(cube);
    const Extraction extraction = ExtractReflections(Generate(cube).View(), With(SurfaceJoining::BestFirst));
    CHECK(extraction.LargestStep < faultThrow);
    std::map<bool, int> surfaces;
    for (const LatticeHorizon& surface : extraction.Surfaces)
    {
      const std::set<bool> sides = SidesOf(generator, surface);
      CHECK(sides.size() <= 1);
      surfaces[false] += int(sides.count(false));
      surfaces[true] += int(sides.count(true));
    }
    CHECK(surfaces[false] >= 5 && surfaces[true] >= 5);
  }
}

/// A hard cube: what the rules are there for. Margins are those of this cube.
void TestHardCube()
{
  CubeGeneratorOptions cube = HardCube(103);
  cube.NoiseFraction = 0.2;
  const CubeGenerator generator(cube);
  const Traces traces = Generate(cube);
  std::map<SurfaceJoining, ExtractionScore> scores;
  for (const SurfaceJoining joining : AllJoinings)
  {
    scores[joining] = ScoreExtraction(generator, ExtractReflections(traces.View(), With(joining)));
  }
  CHECK(scores[SurfaceJoining::BestFirst].Found() > 0.8);
  CHECK(scores[SurfaceJoining::BestFirst].Wrong() < 0.08);
  CHECK(scores[SurfaceJoining::Components].Wrong() > 2.0 * scores[SurfaceJoining::BestFirst].Wrong());
  CHECK(scores[SurfaceJoining::Components].DroppedDuplicates > 0);
  CHECK_EQUAL(scores[SurfaceJoining::BestFirst].DroppedDuplicates, 0);
}

/// Two levels, of 12 and of 20 columns, of different sign.
Traces TwoLevels()
{
  Traces traces = Empty({ 5, 4, 30 });
  for (int n = 0; n < 20; ++n)
  {
    float* const trace = traces.Trace(n % 5, n / 5);
    std::fill_n(trace + 9, 3, -1.0F);
    if (n < 12)
    {
      std::fill_n(trace + 20, 3, n == 7 ? 5.0F : 2.0F);
    }
  }
  return traces;
}

void TestSelection()
{
  const Traces traces = TwoLevels();
  for (const SurfaceJoining joining : AllJoinings)
  {
    ExtractionOptions options = With(joining);
    options.SmallestSize = 12;
    options.SmallestCorrelation = 0.0; // the strong trace looks different
    const Extraction both = ExtractReflections(traces.View(), options);
    CHECK_EQUAL(both.Surfaces.size(), 2u);
    CHECK_EQUAL(both.Surfaces[0].Column.size(), 20u);
    CHECK_EQUAL(both.Surfaces[0].K[0], 10);
    CHECK_EQUAL(both.Surfaces[0].Amplitude[0], -1.0);
    CHECK_EQUAL(both.Surfaces[1].Amplitude[7], 5.0);
    CHECK_EQUAL(both.Surfaces[1].Thickness[7], 3.0);
    CHECK_EQUAL(both.Picks, 32);
    options.LargestNumber = 1;
    CHECK_EQUAL(ExtractReflections(traces.View(), options).Surfaces.size(), 1u);
    CHECK_EQUAL(ExtractReflections(traces.View(), options).NumberOfSurfaces, 2);
    options.SmallestSize = 13;
    CHECK_EQUAL(ExtractReflections(traces.View(), options).NumberOfSurfaces, 1);
    options.SmallestSize = 0; // a twentieth of the traces, 10 at least
    CHECK_EQUAL(ExtractReflections(traces.View(), options).SmallestSize, 10);
    CHECK_EQUAL(ExtractReflections(traces.View(), options).NumberOfSurfaces, 2);
    options.SmallestSize = 21;
    CHECK(ExtractReflections(traces.View(), options).Surfaces.empty());
  }
}

/// A component that has two voxels in a column keeps the stronger one, as from a file of voxels.
void TestDuplicates()
{
  Traces traces = Empty({ 2, 1, 12 });
  traces.Trace(0, 0)[5] = 1.0F;
  traces.Trace(1, 0)[3] = 2.0F;
  traces.Trace(1, 0)[7] = 3.0F;
  ExtractionOptions options = With(SurfaceJoining::Components);
  options.Reflections.AmplitudePercentile = 0.0;
  options.LargestStep = 2.0;
  options.SmallestSize = 2;
  const Extraction found = ExtractReflections(traces.View(), options);
  CHECK_EQUAL(found.Surfaces.size(), 1u);
  CHECK_EQUAL(found.Surfaces[0].Column.size(), 2u);
  CHECK_EQUAL(found.Surfaces[0].K[1], 7);
  CHECK_EQUAL(found.Surfaces[0].DroppedDuplicates, 1);
  options.SmallestSize = 3; // columns count
  CHECK(ExtractReflections(traces.View(), options).Surfaces.empty());
}

/// Traces of one sample, a single trace, dead cubes, and cubes of noise.
void TestDegenerate()
{
  for (const SurfaceJoining joining : AllJoinings)
  {
    ExtractionOptions options = With(joining);
    options.SmallestSize = 1;
    options.Reflections.AmplitudePercentile = 0.0;
    Traces flat = Empty({ 6, 5, 1 });
    std::fill(flat.Samples.begin(), flat.Samples.end(), 2.0F);
    const Extraction plane = ExtractReflections(flat.View(), options);
    CHECK_EQUAL(plane.Surfaces.size(), 1u);
    CHECK_EQUAL(plane.Surfaces[0].Column.size(), 30u);
    Traces single = Empty({ 1, 1, 5 });
    single.Samples[2] = -1.0F;
    CHECK_EQUAL(ExtractReflections(single.View(), options).Surfaces.size(), 1u);
    CHECK(ExtractReflections(Empty({ 3, 3, 3 }).View(), options).Surfaces.empty());
    options.Connectivity = ColumnConnectivity::Eight;
    CheckSurfaces(ExtractReflections(Rough({ 20, 20, 30 }, 9).View(), options), options);
  }
}

void TestErrors()
{
  const Traces traces = TwoLevels();
  const auto refuse = [&](auto&& change, const std::string& message)
  {
    ExtractionOptions options;
    change(options);
    CHECK_THROWS_WITH(ExtractReflections(traces.View(), options), message);
  };
  refuse([](auto& options) { options.LargestStep = -1.0; }, "LargestStep -1, expected 0 to 262143 samples");
  refuse([](auto& options) { options.LargestStep = std::nan(""); }, "LargestStep nan, expected 0 to 262143 samples");
  refuse([](auto& options) { options.SmallestCorrelation = 1.5; }, "SmallestCorrelation 1.5, expected 0 to 1");
  refuse([](auto& options) { options.SmallestContact = -0.5; }, "SmallestContact -0.5, expected 0 to 1");
  refuse([](auto& options) { options.SmallestSize = -1; }, "SmallestSize -1, expected at least 0 picks");
  refuse([](auto& options) { options.LargestNumber = 0; }, "LargestNumber 0, expected at least 1 surface");
  refuse(
    [](auto& options) { options.Reflections.AmplitudePercentile = 200.0; }, "AmplitudePercentile 200, expected 0 to");
}

void TestMonitor()
{
  const Traces traces = Generate(SmallCube(0.2));
  for (const SurfaceJoining joining : AllJoinings)
  {
    CHECK_EQUAL(MonitorChecker::Check(
                  4, [&](const Monitor& monitor) { ExtractReflections(traces.View(), With(joining), monitor); }),
      "");
  }
}
}

int TestReflectionExtraction(int, char*[])
{
  TestThreads();
  TestEasyCube();
  TestNoise();
  TestSampling();
  TestBias();
  TestLittleLeft();
  TestFault();
  TestHardCube();
  TestSelection();
  TestDuplicates();
  TestDegenerate();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
