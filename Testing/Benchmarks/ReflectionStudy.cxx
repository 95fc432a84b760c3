// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the horizons of generated cubes is found, and how much wrong, over noise and throws, for each way of
// joining picks. Prints the page Documentation/ReflectionTables.md:
//
//   ReflectionStudy [CUBES] > Documentation/ReflectionTables.md      CUBES of each kind; without it 12

#include "GuidedStudy.h"
#include "Tools/ExtractionScore.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
// Cubes that no constant was chosen by have seeds from here on.
constexpr std::uint64_t FirstSeed = 1000;

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
  std::vector<Method> methods(2, { "", options });
  methods[0].Name = "components";
  methods[0].Options.Joining = SurfaceJoining::Components;
  methods[0].Options.Connectivity = ColumnConnectivity::Eight;
  methods[0].Options.LargestStep = 1.0;
  methods[0].Options.Reflections.Position = ReflectionPosition::Middle;
  methods[0].Options.Reflections.AmplitudePercentile = 70.0;
  methods[1].Name = "best first";
  return methods;
}

struct NoiseLevel
{
  std::string Name;
  double Fraction = 0.0;
  NoiseKind Kind = NoiseKind::White;
};

const std::vector<NoiseLevel> NoiseLevels = { { "none", 0.0, NoiseKind::White },
  { "50 % white", 0.5, NoiseKind::White }, { "50 % in band", 0.5, NoiseKind::InBand } };

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
    const ExtractionScore score = ScoreExtraction(cube, ExtractFrom(cube, options));
    total.Score.Add(score);
    total.Weakest += score.WeakestFound / cubes;
  }
  return total;
}

void PrintRow(const Method& method, const NoiseLevel& noise, const Total& total)
{
  const ExtractionScore& score = total.Score;
  std::printf("| %s | %s | %.1f | %.1f | %.2f | %.2f | %.2f | %.1f |\n", method.Name.c_str(), noise.Name.c_str(),
    100.0 * score.Found(), 100.0 * total.Weakest, 100.0 * score.Wrong(), 100.0 * score.Leaked(),
    score.ErrorPercentile(50.0), score.PerReflector());
  std::fflush(stdout);
}

Total ScoreNoise(int cubes, const Method& method, const NoiseLevel& noise, bool isHard)
{
  return ScoreCubes(cubes, method.Options,
    [&](std::uint64_t seed)
    {
      CubeGeneratorOptions options = isHard ? HardCube(seed) : CubeGeneratorOptions();
      options.Seed = seed;
      options.NoiseFraction = noise.Fraction;
      options.Noise = noise.Kind;
      return options;
    });
}

void PrintNoiseTable(int cubes)
{
  std::printf("| joining | noise | found %% | weakest %% | wrong %% | leak %% | error | surfaces |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Method& method : ListMethods())
  {
    for (const NoiseLevel& noise : NoiseLevels)
    {
      PrintRow(method, noise, ScoreNoise(cubes, method, noise, true));
    }
  }
  std::printf("\n");
}

/// The worst of all noises.
void PrintEasyTable(int cubes)
{
  std::printf("| joining | found %% | weakest %% | wrong %% | leak %% | error | surfaces |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Method& method : ListMethods())
  {
    double found = 1.0, weakest = 1.0, wrong = 0.0, leaked = 0.0, error = 0.0, surfaces = 0.0;
    for (const NoiseLevel& noise : NoiseLevels)
    {
      const Total total = ScoreNoise(cubes, method, noise, false);
      found = std::min(found, total.Score.Found());
      weakest = std::min(weakest, total.Weakest);
      wrong = std::max(wrong, total.Score.Wrong());
      leaked = std::max(leaked, total.Score.Leaked());
      error = std::max(error, total.Score.ErrorPercentile(50.0));
      surfaces = std::max(surfaces, total.Score.PerReflector());
    }
    std::printf("| %s | %.1f | %.1f | %.2f | %.2f | %.2f | %.1f |\n", method.Name.c_str(), 100.0 * found,
      100.0 * weakest, 100.0 * wrong, 100.0 * leaked, error, surfaces);
    std::fflush(stdout);
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
    for (const std::size_t level : { 0, 1 })
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

constexpr const char* Head = R"(# Reflectors found

These tables show how well [Seismic Reflection Extraction](SeismicReflectionExtraction.md) recovers the reflectors of
synthetic cubes (`generate_cube`) with its defaults. `ReflectionStudy` measures and writes this page; no constant of the
method was tuned on these cubes. *Components* uses the settings of the thesis: `Position` Middle, `AmplitudePercentile`
70, `Connectivity` Eight and `LargestStep` 1.

- *found*: reflector columns in the best surface of each reflector and side of the fault; *weakest*: the same for the
  weakest reflector of each cube, averaged over the cubes;
- *wrong*: picks of these surfaces at least a quarter of a period off the reflector, or where it is absent;
- *leak*: picks on the side of the fault where their surface has fewer, in surfaces of at least 200 picks;
- *error*: median, in samples; *surfaces*: surfaces of at least 10 picks per reflector, ideally two, as the fault cuts
  each reflector.
)";

constexpr const char* Easy = R"(## Easy cubes

Both methods find nearly everything. The table has the worse of no noise and 50 %% noise, for %d cubes of 80 x 64 traces
of 220 samples, with layers 32 samples apart, folds, and a fault of half a layer; Ricker wavelet of 30 Hz, 4 ms.
)";

constexpr const char* Hard = R"(## Hard cubes

*Best first* links few wrong picks, *components* many. %d cubes of the same size: layers of 1.3 to 3.5 periods that fade
to 0.12 of their strength, a fault of 0.25 to 3.25 periods, a channel, dead and missing traces, and wavelets of 25 to 38
Hz. Layers cannot be found where they fade into the noise, or merge with a neighbour into one wavelet.
)";

constexpr const char* Leak = R"(## Leak across the fault, by its throw

Throws below a fifth of a period look like a dip. Above, *best first* leaks least. Percentages from %d hard cubes each;
P is the period of the wavelet.
)";
}

int main(int argc, char* argv[])
{
  const int cubes = argc > 1 ? std::atoi(argv[1]) : 12;
  std::printf("%s\n", Head);
  std::printf(Easy, cubes);
  std::printf("\n");
  PrintEasyTable(cubes);
  std::printf(Hard, cubes);
  std::printf("\n");
  PrintNoiseTable(cubes);
  const int throwCubes = (cubes + 3) / 4;
  std::printf(Leak, throwCubes);
  std::printf("\n");
  PrintThrowTable(throwCubes);
  const int wildCubes = (cubes + 1) / 2;
  std::printf("\n");
  PrintGuidedStudy(wildCubes);
  return EXIT_SUCCESS;
}
