// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the horizons of generated cubes is found, and how much wrong, over noise and throws, for each way of
// joining picks. Prints the page Documentation/ReflectionTables.md:
//
//   ReflectionStudy [CUBES] > Documentation/ReflectionTables.md      CUBES of each kind; without it 12

#include "Generator/CubeGenerator.h"
#include "Reflections/ReflectionExtraction.h"
#include "Tools/ExtractionScore.h"
#include "Tools/GuideScore.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
// Cubes that no constant was chosen by have seeds from here on.
constexpr std::uint64_t FirstSeed = 1000;
constexpr std::uint64_t FirstWildSeed = 2000;

struct Method
{
  std::string Name;
  ExtractionOptions Options;
};

std::vector<Method> ListMethods()
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.LargestNumber = 1000000;
  std::vector<Method> methods(3, { "", options });
  methods[0].Name = "components, as in the thesis";
  methods[0].Options.Joining = SurfaceJoining::Components;
  methods[0].Options.Connectivity = ColumnConnectivity::Eight;
  methods[0].Options.LargestStep = 1.0;
  methods[0].Options.Reflections.Position = ReflectionPosition::Middle;
  methods[0].Options.Reflections.AmplitudePercentile = 70.0;
  methods[1].Name = "best first";
  methods[2].Name = "continuous";
  methods[2].Options.Joining = SurfaceJoining::Continuous;
  return methods;
}

struct NoiseLevel
{
  std::string Name;
  double Fraction = 0.0;
  NoiseKind Kind = NoiseKind::White;
};

const std::vector<NoiseLevel> NoiseLevels = { { "none", 0.0, NoiseKind::White },
  { "10 % white", 0.1, NoiseKind::White }, { "20 % white", 0.2, NoiseKind::White },
  { "20 % in band", 0.2, NoiseKind::InBand }, { "50 % white", 0.5, NoiseKind::White },
  { "50 % in band", 0.5, NoiseKind::InBand } };

Extraction Extract(const CubeGenerator& cube, const ExtractionOptions& options, const std::vector<Guide>& guides = {})
{
  const std::vector<float> traces = cube.MakeTraces();
  const std::array<int, 3>& size = cube.Options().Size;
  StridedSamples<float> samples;
  samples.First = traces.data();
  samples.Strides = { size[2], std::ptrdiff_t(size[0]) * size[2], 1 };
  return ExtractReflections(MakeTraceCube(size, samples), options, Monitor(), guides);
}

/// The score over some cubes, and the mean over them of the weakest reflector's share.
struct Total
{
  ExtractionScore Score;
  double Weakest = 0.0;
};

template <typename MakeOptions>
Total ScoreCubes(int cubes, const ExtractionOptions& options, MakeOptions&& makeOptions)
{
  Total total;
  for (int n = 0; n < cubes; ++n)
  {
    const CubeGenerator cube(makeOptions(FirstSeed + std::uint64_t(n)));
    const ExtractionScore score = ScoreExtraction(cube, Extract(cube, options));
    total.Score.Add(score);
    total.Weakest += score.WeakestFound / cubes;
  }
  return total;
}

void PrintRow(const Method& method, const NoiseLevel& noise, const Total& total, bool isHard)
{
  const ExtractionScore& score = total.Score;
  std::printf("| %s | %s | %.1f | %.1f | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f | %s |\n", method.Name.c_str(),
    noise.Name.c_str(), 100.0 * score.Found(), 100.0 * total.Weakest, 100.0 * score.Wrong(), 100.0 * score.Leaked(),
    score.ErrorPercentile(50.0), score.ErrorPercentile(99.0), score.PerReflector(), 100.0 * score.Duplicates(),
    isHard ? std::to_string(std::lround(100.0 * score.Taken())).c_str() : "-");
  std::fflush(stdout);
}

void PrintNoiseTable(int cubes, bool isHard)
{
  std::printf(
    "| joining | noise | found %% | weakest %% | wrong %% | leak %% | error, median | error, 99 %% | surfaces | "
    "twice %% | channel %% |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Method& method : ListMethods())
  {
    for (const NoiseLevel& noise : NoiseLevels)
    {
      const Total total = ScoreCubes(cubes, method.Options,
        [&](std::uint64_t seed)
        {
          CubeGeneratorOptions options = isHard ? HardCube(seed) : CubeGeneratorOptions();
          options.Seed = seed;
          options.NoiseFraction = noise.Fraction;
          options.Noise = noise.Kind;
          return options;
        });
      PrintRow(method, noise, total, isHard);
    }
  }
  std::printf("\n");
}

void PrintThrowTable(int cubes)
{
  const std::vector<double> throws = { 0.15, 0.25, 0.5, 1.0, 2.0, 4.0 };
  std::printf(
    "| joining, noise | 0.15 P | 0.25 P | 0.5 P | 1 P | 2 P | 4 P |\n| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Method& method : ListMethods())
  {
    for (const std::size_t level : { 0, 2, 4 })
    {
      std::printf("| %s, %s |", method.Name.c_str(), NoiseLevels[level].Name.c_str());
      for (const double faultThrow : throws)
      {
        const Total total = ScoreCubes(cubes, method.Options,
          [&](std::uint64_t seed)
          {
            CubeGeneratorOptions options = HardCube(seed);
            options.FaultThrow = faultThrow * 1000.0 / (options.Frequency * options.SampleInterval);
            options.NoiseFraction = NoiseLevels[level].Fraction;
            return options;
          });
        std::printf(" %.1f |", 100.0 * total.Score.Leaked());
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}

// ---- Guided --------------------------------------------------------------------------------------------------------

struct GuidedPlan
{
  std::string Name;
  PickPlan Picks;
};

const std::vector<GuidedPlan> GuidedPlans = { { "1", { 1, 0.0, 0.0 } }, { "5", { 5, 0.0, 0.0 } },
  { "5, within 2 samples", { 5, 2.0, 0.0 } }, { "5, one of ten on the next reflector", { 5, 0.0, 0.1 } },
  { "20", { 20, 0.0, 0.0 } }, { "every 20th line", { 0, 0.0, 0.0 } },
  { "every 20th line, within 2 samples", { 0, 2.0, 0.0 } } };

/// The surface of each reflector, empty where its guide has no pick.
std::vector<LatticeHorizon> ExtractGuided(
  const CubeGenerator& cube, const ExtractionOptions& options, const std::vector<Guide>& guides)
{
  std::vector<Guide> given;
  for (const Guide& guide : guides)
  {
    if (!guide.Picks.empty())
    {
      given.push_back(guide);
    }
  }
  std::vector<LatticeHorizon> found = Extract(cube, options, given).Surfaces;
  std::vector<LatticeHorizon> surfaces(guides.size());
  std::size_t next = 0;
  for (std::size_t n = 0; n < guides.size(); ++n)
  {
    if (!guides[n].Picks.empty())
    {
      surfaces[n] = std::move(found[next++]);
    }
  }
  return surfaces;
}

void PrintGuidedRow(const std::string& name, const GuideScore& score, double weakest)
{
  std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", name.c_str(), 100.0 * score.Found(), 100.0 * weakest,
    100.0 * score.Off(), 100.0 * score.Absent());
  std::fflush(stdout);
}

void PrintGuidedTables(int cubes)
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.LargestNumber = 1000000;
  for (const double noise : { 0.0, 0.2, 0.5 })
  {
    std::printf(
      "| picks, noise %.0f %% | found %% | weakest %% | off %% | absent %% |\n| --- | --- | --- | --- | --- |\n",
      100.0 * noise);
    std::vector<CubeGenerator> generators;
    for (int n = 0; n < cubes; ++n)
    {
      CubeGeneratorOptions wild = WildCube(FirstWildSeed + std::uint64_t(n));
      wild.NoiseFraction = noise;
      wild.Noise = NoiseKind::Mixed;
      generators.emplace_back(wild);
    }
    const auto print = [&](const std::string& name, auto&& score)
    {
      GuideScore total;
      double weakest = 0.0;
      for (const CubeGenerator& cube : generators)
      {
        const GuideScore one = score(cube);
        total.Add(one);
        weakest += one.Weakest / cubes;
      }
      PrintGuidedRow(name, total, weakest);
    };
    int strong = 0;
    int large = 0;
    print("none",
      [&](const CubeGenerator& cube)
      {
        constexpr std::size_t first = 20;
        options.Order = SurfaceOrder::Size;
        large += CountMain(cube, Extract(cube, options).Surfaces, first);
        options.Order = SurfaceOrder::Strength;
        const std::vector<LatticeHorizon> surfaces = Extract(cube, options).Surfaces;
        strong += CountMain(cube, surfaces, first);
        return ScoreUnguided(cube, surfaces);
      });
    for (const GuidedPlan& plan : GuidedPlans)
    {
      print(plan.Name,
        [&](const CubeGenerator& cube)
        { return ScoreGuided(cube, ExtractGuided(cube, options, MakeGuides(cube, plan.Picks, cube.Options().Seed))); });
    }
    std::printf(
      "\nOf the first 20 surfaces at %.0f %% noise, %.1f lie on a reflector or a channel's floor by strength, and %.1f by "
      "size; the others on side lobes.\n\n",
      100.0 * noise, double(strong) / cubes, double(large) / cubes);
  }
}

constexpr const char* Head = R"(# How much is found

Horizons of generated cubes (`generate_cube`), whose reflectors are known, as [Seismic Reflection
Extraction](SeismicReflectionExtraction.md) finds them with its defaults (components: `Position` Middle, `AmplitudePercentile`
70, `Connectivity` Eight, `LargestStep` 1). Made by `ReflectionStudy`; no constant of the method was chosen by these cubes.

- *found*: of the places of all reflectors those that the best surface of the reflector has on that side of the fault;
  *weakest*: the same of the reflector of each cube of which least is found, the mean of the cubes;
- *wrong*: of the picks of best surfaces those off the reflector of the surface, a quarter of a period away or more, or
  where the reflector is not, as in the gap of the fault;
- *leak*: of the picks of all surfaces of 200 or more those on the side of the fault where the surface has fewer, without
  1.5 columns to each side of it;
- *error*: of the places found, in samples; *surfaces*: how many of 10 picks or more there are for each reflector, two
  at least, as the fault cuts each; *twice*: picks dropped as their surface had another one in the column; *channel*:
  columns where the channel cut the reflector away that its surface continues through.

## What bounds it

- In easy cubes noise of half the signal breaks layers up into parts, which the means of their waveforms join again. The
  wrong picks that are left are in the first columns of the fault's gap, where traces have nothing but noise.
- In hard cubes a layer that fades to noise, or is joined with a neighbour to one wavelet, is not there to be found. Throws of
  less than a fifth of a period look like a dip.
)";
}

int main(int argc, char* argv[])
{
  const int cubes = argc > 1 ? std::atoi(argv[1]) : 12;
  std::printf(
    "%s\n## Easy cubes\n\n%d cubes of 80 x 64 traces of 220 samples: layers 32 samples apart, their strengths from "
    "0.4 to 1 and the same all over, folds, and a fault of half a layer, across which no reflector faces another. "
    "Ricker wavelet of 30 Hz, 4 ms.\n\n",
    Head, cubes);
  PrintNoiseTable(cubes, false);
  std::printf(
    "## Hard cubes\n\n%d cubes of the same size: layers of 1.3 to 3.5 periods that fade to 0.12 of their strength, "
    "a fault of 0.25 to 3.25 periods, a channel, dead and missing traces, wavelets of 25 to 38 Hz.\n\n",
    cubes);
  PrintNoiseTable(cubes, true);
  const int throwCubes = (cubes + 3) / 4;
  std::printf(
    "## Leak over the fault, by its throw\n\nPercent, %d hard cubes for each; P is the period of the wavelet.\n\n",
    throwCubes);
  PrintThrowTable(throwCubes);
  const int wildCubes = (cubes + 1) / 2;
  std::printf(
    "\n## Guided\n\n%d wild cubes (`generate_cube --wild`) of 110 x 96 traces of 280 samples: hard ones with an "
    "unconformity, two channels, and one to four short faults beside the long one; half of the noise is in band, a "
    "quarter white, and a quarter dipping waves. *Picks*: so many at random in each part of a reflector, 3 columns "
    "from "
    "its rim or more, or all places of every 20th line; parts are connected columns by steps of a quarter of a period, "
    "100 or more. *Found*: of the places of parts those that the surface of the reflector has; without picks the "
    "surface "
    "is the best one of each part. *Off*: of its picks where the reflector is those more than half a period away; "
    "*absent*: of all its picks those where the reflector is not.\n\n",
    wildCubes);
  PrintGuidedTables(wildCubes);
  return EXIT_SUCCESS;
}
