// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The phase of generated cubes is found, and turned.

#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/ExtractionScore.h"

#include <cmath>
#include <limits>

using namespace PickFixtures;

namespace
{
CubeGeneratorOptions CubeOf(double phase, double noise)
{
  CubeGeneratorOptions options = HardCube(11);
  options.Size = { 40, 30, 280 };
  options.Phase = phase;
  options.NoiseFraction = noise;
  return options;
}

/// The difference of two phases that count by 180 degrees.
double Difference(double a, double b)
{
  const double difference = std::fmod(std::abs(a - b), 180.0);
  return std::min(difference, 180.0 - difference);
}

void TestEstimate()
{
  for (const double noise : { 0.0, 0.5 })
  {
    for (const double phase : { 0.0, 30.0, 90.0, -60.0, 150.0 })
    {
      const Traces traces = Generate(CubeOf(phase, noise));
      const auto [one, three] = OnThreads([&]() { return EstimatePhase(traces.View()); });
      CHECK(one.Degrees == three.Degrees && one.Deviation == three.Deviation);
      CHECK(one.Degrees >= -90.0 && one.Degrees < 90.0);
      CHECK(Difference(one.Degrees, phase) <= 6.0);
      CHECK(one.Deviation < 12.0);
    }
  }
  const WaveletPhase none = EstimatePhase(Empty({ 5, 4, 20 }).View());
  CHECK_EQUAL(none.Degrees, 0.0);
  CHECK_EQUAL(none.Deviation, 0.0);
  Traces noise = Empty({ 40, 40, 200 });
  std::mt19937 random(3);
  std::generate(
    noise.Samples.begin(), noise.Samples.end(), [&random]() { return float(random() % 2001) / 1000.0F - 1.0F; });
  CHECK(EstimatePhase(noise.View()).Deviation > 12.0);
}

/// A cube of another phase, turned back, is that of phase 0; turned by 180 degrees it is its negative. Missing samples
/// stay missing, and dead traces dead.
void TestTurn()
{
  Traces turned = Generate(CubeOf(90.0, 0.0));
  const Traces plain = Generate(CubeOf(0.0, 0.0));
  turned.Trace(7, 7)[100] = std::numeric_limits<float>::quiet_NaN();
  const TraceCube back = TurnPhase(turned.View(), -90.0);
  const TraceCube reversed = TurnPhase(turned.View(), 180.0);
  std::vector<float> row(40 * 280);
  std::vector<float> negative(row.size());
  double difference = 0.0;
  double energy = 0.0;
  for (int j = 0; j < 30; ++j)
  {
    back.Read(j, 0, 40, row.data());
    reversed.Read(j, 0, 40, negative.data());
    for (std::size_t n = 0; n < row.size(); ++n)
    {
      const float before = turned.Samples[std::size_t(j) * row.size() + n];
      const float expected = plain.Samples[std::size_t(j) * row.size() + n];
      CHECK_EQUAL(std::isnan(row[n]), std::isnan(before));
      CHECK(std::isnan(before) || std::abs(negative[n] + before) < 1e-5F);
      const bool isCompared = !std::isnan(before) && !(j == 7 && n / 280 == 7);
      difference += isCompared ? (row[n] - expected) * (row[n] - expected) : 0.0;
      energy += isCompared ? expected * expected : 0.0;
    }
  }
  CHECK(difference < 0.01 * energy);
}

/// With the phase of 0 again, picks are on the interfaces.
void TestPicks()
{
  const CubeGenerator cube(CubeOf(90.0, 0.1));
  const Traces traces = Generate(cube.Options());
  ExtractionOptions options;
  const ExtractionScore before = ScoreExtraction(cube, ExtractReflections(traces.View(), options));
  options.PhaseRotation = -90.0;
  const Extraction extraction = ExtractReflections(traces.View(), options);
  const ExtractionScore after = ScoreExtraction(cube, extraction);
  CHECK(Difference(extraction.Phase.Degrees, 0.0) <= 6.0);
  CHECK(after.ErrorPercentile(50.0) < 0.2);
  CHECK(before.ErrorPercentile(50.0) > 1.0);
  CHECK(after.Found() > before.Found());
  options.PhaseRotation = 200.0;
  CHECK_THROWS_WITH(ExtractReflections(traces.View(), options), "PhaseRotation 200, expected -180 to 180 degrees");
}
}

int TestWaveletPhase(int, char*[])
{
  TestEstimate();
  TestTurn();
  TestPicks();
  return Check::Result();
}
