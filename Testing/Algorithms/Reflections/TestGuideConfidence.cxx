// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The confidence of guided surfaces: on picks made by hand, and beside the known reflectors of cubes.

#include "Filters/Algorithms/Reflections/GuideConfidence.h"
#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/GuideScore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace PickFixtures;

namespace
{
constexpr PickDepth Quarter = 2 * DepthsPerSample;

/// Jumps of more than half a period part blocks, and given picks do not reach across.
void TestBlocks()
{
  const ReflectionPicks picks = MakePicks({ 7, 1 }, { { 10 }, { 30 }, { 31 }, { 34 }, { 10 }, { 13 }, { 20 } });
  GuidedSurface surface;
  for (PointId pick = 0; pick < 7; ++pick)
  {
    surface.Picks.push_back({ pick });
  }
  surface.Picks[2].Origin = PickOrigin::Guide;
  surface.Picks[2].Seed = 8;
  surface.Picks[6].Origin = PickOrigin::Guide;
  surface.Picks[6].Seed = 3;
  FindBlocks(picks, Quarter, surface);
  const std::array<std::int32_t, 7> blocks = { 3, 1, 1, 1, 2, 2, 4 };
  const std::array<std::int32_t, 7> seeds = { -1, 8, 8, 8, -1, -1, 3 };
  for (std::size_t n = 0; n < 7; ++n)
  {
    CHECK_EQUAL(surface.Picks[n].Block, blocks[n]);
    CHECK_EQUAL(surface.Picks[n].Seed, seeds[n]);
  }
}

/// A pick is as doubtful as the picks around it, those on the other side of a jump aside.
void TestPatches()
{
  std::vector<std::vector<double>> places(49, { 20.0 });
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    places[n][0] += n % 7 > 3 ? 9.0 : 0.0;
  }
  const ReflectionPicks picks = MakePicks({ 7, 7 }, places);
  const auto measure = [&](float here, float there, bool isPart)
  {
    std::vector<Candidate> surface(49);
    for (PointId pick = 0; pick < 49; ++pick)
    {
      surface[pick] = { pick, pick % 7 > 3 ? there : here, 0.0F, isPart };
    }
    surface[24].Likeness = 0.0F;
    return MeasureConfidence(picks, surface, Quarter);
  };
  const std::vector<float> alike = measure(0.95F, 0.2F, true);
  CHECK(alike[24] > 0.9F && alike[0] > 0.99F && alike[6] < 0.6F);
  CHECK(measure(0.95F, 0.95F, true)[24] == alike[24]);
  CHECK(measure(0.95F, 0.2F, false)[24] < alike[24] && measure(0.5F, 0.2F, true)[24] < alike[24]);
  std::vector<Candidate> none(49);
  CHECK_EQUAL(MeasureConfidence(picks, none, Quarter)[24], 0.0F);
}

struct Bin
{
  double Picks = 0.0;
  double Right = 0.0;
  double Off = 0.0;
};

/// Of the picks with a confidence of about a half, about half are right, and of those above 0.9 nearly all.
void TestCalibration()
{
  std::array<Bin, 3> bins; // below 0.3, to 0.7, from 0.9 on
  for (const auto& [seed, noise] : { std::pair(41, 0.0), std::pair(42, 0.2), std::pair(43, 0.5) })
  {
    CubeGeneratorOptions options = WildCube(std::uint64_t(seed));
    options.NoiseFraction = noise;
    options.Noise = NoiseKind::Mixed;
    const CubeGenerator cube(options);
    const Traces traces = Generate(options);
    std::vector<Guide> guides = MakeGuides(cube, { 3, 0.0, 0.0 }, 5);
    std::vector<int> reflectors;
    for (std::size_t n = guides.size(); n-- > 0;)
    {
      if (guides[n].Picks.empty())
      {
        guides.erase(guides.begin() + std::ptrdiff_t(n));
      }
      else
      {
        reflectors.insert(reflectors.begin(), int(n));
      }
    }
    const Extraction found = ExtractReflections(traces.View(), ExtractionOptions(), Monitor(), guides);
    for (std::size_t n = 0; n < guides.size(); ++n)
    {
      const LatticeHorizon& surface = found.Surfaces[n];
      CHECK_EQUAL(surface.Attributes[0].first, "Confidence");
      const std::vector<double> misses = MeasureMisses(cube, reflectors[n], surface);
      for (std::size_t pick = 0; pick < misses.size(); ++pick)
      {
        const double confidence = surface.Attributes[0].second[pick];
        if (confidence < 0.7 || confidence >= 0.9)
        {
          Bin& bin = bins[confidence < 0.3 ? 0 : (confidence < 0.7 ? 1 : 2)];
          bin.Picks += std::isinf(misses[pick]) ? 0.0 : 1.0;
          bin.Off += !std::isinf(misses[pick]) && misses[pick] > 1.0 ? 1.0 : 0.0;
          bin.Right += misses[pick] <= 1.0 ? 1.0 : 0.0;
        }
      }
    }
  }
  CHECK(bins[0].Picks > 100.0 && bins[0].Right < 0.6 * bins[0].Picks);
  CHECK(bins[1].Picks > 100.0 && bins[1].Right > 0.4 * bins[1].Picks && bins[1].Off > 0.02 * bins[1].Picks);
  CHECK(bins[2].Picks > 10000.0 && bins[2].Off < 0.01 * bins[2].Picks);
}

/// The least confidence leaves out what has less, but no given pick.
void TestLeastConfidence()
{
  CubeGeneratorOptions cubeOptions = WildCube(44);
  cubeOptions.NoiseFraction = 0.5;
  const CubeGenerator cube(cubeOptions);
  const Traces traces = Generate(cubeOptions);
  std::vector<Guide> guides = { MakeGuides(cube, { 3, 0.0, 0.0 }, 5)[2] };
  ExtractionOptions options;
  const LatticeHorizon all = ExtractReflections(traces.View(), options, Monitor(), guides).Surfaces[0];
  options.Guidance.LeastConfidence = 0.8;
  const Extraction extraction = ExtractReflections(traces.View(), options, Monitor(), guides);
  const LatticeHorizon& sure = extraction.Surfaces[0];
  std::vector<PlanePoint> expected;
  for (std::size_t pick = 0; pick < all.Column.size(); ++pick)
  {
    if (float(all.Attributes[0].second[pick]) >= 0.8 || PickOrigin(all.Labels[0].second[pick]) == PickOrigin::Guide)
    {
      expected.push_back(all.Column[pick]);
    }
  }
  CHECK(std::equal(expected.begin(), expected.end(), sure.Column.begin(), sure.Column.end()));
  CHECK_EQUAL(extraction.Guides[0].Doubtful, std::int64_t(all.Column.size() - sure.Column.size()));
  CHECK(extraction.Guides[0].Doubtful > 20);
  options.Guidance.LeastConfidence = 1.1;
  CHECK_THROWS_WITH(
    ExtractReflections(traces.View(), options, Monitor(), guides), "LeastConfidence 1.1, expected 0 to 1");
}
}

int TestGuideConfidence(int, char*[])
{
  TestBlocks();
  TestPatches();
  TestCalibration();
  TestLeastConfidence();
  return Check::Result();
}
