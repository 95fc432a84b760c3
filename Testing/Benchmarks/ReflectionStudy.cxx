// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the horizons of generated cubes is found, and how much wrong, over noise and throws, for each way of
// joining picks. Prints the page Documentation/ReflectionTables.md:
//
//   ReflectionStudy [CUBES] > Documentation/ReflectionTables.md      CUBES of each kind; without it 12

#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Generator/CubeGenerator.h"
#include "PlainTracker.h"
#include "Tools/ExtractionScore.h"
#include "Tools/GuideScore.h"

#include <algorithm>
#include <array>
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

// ---- Guided --------------------------------------------------------------------------------------------------------

struct GuidedPlan
{
  std::string Name;
  PickPlan Picks;
};

const std::vector<GuidedPlan> GuidedPlans = { { "1", { 1, 0.0, 0.0 } }, { "5", { 5, 0.0, 0.0 } },
  { "5, within 2 samples", { 5, 2.0, 0.0 } }, { "5, one of ten on the next reflector", { 5, 0.0, 0.1 } },
  { "20", { 20, 0.0, 0.0 } }, { "every 20th line", { 0, 0.0, 0.0 } } };

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

std::vector<LatticeHorizon> TrackAll(const CubeGenerator& cube, const std::vector<Guide>& guides)
{
  const std::vector<float> traces = cube.MakeTraces();
  const double period = 1000.0 / (cube.Options().Frequency * cube.Options().SampleInterval);
  std::vector<LatticeHorizon> surfaces;
  for (const Guide& guide : guides)
  {
    surfaces.push_back(TrackPlainly(traces, cube.Options().Size, period, guide));
  }
  return surfaces;
}

const std::vector<double> GuidedNoises = { 0.0, 0.2, 0.5 };

std::vector<CubeGenerator> MakeWildCubes(int cubes, double noise)
{
  std::vector<CubeGenerator> generators;
  for (int n = 0; n < cubes; ++n)
  {
    CubeGeneratorOptions wild = WildCube(FirstWildSeed + std::uint64_t(n));
    wild.NoiseFraction = noise;
    wild.Noise = NoiseKind::Mixed;
    generators.emplace_back(wild);
  }
  return generators;
}

/// A row of the table: `score` gives that of a cube.
template <typename Score>
void PrintGuidedRow(const std::string& name, int cubes, Score&& score)
{
  std::printf("| %s |", name.c_str());
  for (const double noise : GuidedNoises)
  {
    GuideScore total;
    double weakest = 0.0;
    for (const CubeGenerator& cube : MakeWildCubes(cubes, noise))
    {
      const GuideScore one = score(cube);
      total.Add(one);
      weakest += one.Weakest / cubes;
    }
    std::printf(
      " %.1f/%.1f/%.1f/%.1f |", 100.0 * total.Found(), 100.0 * weakest, 100.0 * total.Off(), 100.0 * total.Absent());
    std::fflush(stdout);
  }
  std::printf("\n");
}

void PrintGuidedTable(int cubes)
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.LargestNumber = 1000000;
  std::printf("| picks |");
  for (const double noise : GuidedNoises)
  {
    std::printf(" noise %.0f %% |", 100.0 * noise);
  }
  std::printf("\n| --- | --- | --- | --- |\n");
  PrintGuidedRow(
    "none", cubes, [&](const CubeGenerator& cube) { return ScoreUnguided(cube, Extract(cube, options).Surfaces); });
  for (const GuidedPlan& plan : GuidedPlans)
  {
    PrintGuidedRow(plan.Name, cubes,
      [&](const CubeGenerator& cube)
      { return ScoreGuided(cube, ExtractGuided(cube, options, MakeGuides(cube, plan.Picks, cube.Options().Seed))); });
    PrintGuidedRow("- plain tracker", cubes,
      [&](const CubeGenerator& cube)
      { return ScoreGuided(cube, TrackAll(cube, MakeGuides(cube, plan.Picks, cube.Options().Seed))); });
  }
}

// ---- Confidence ----------------------------------------------------------------------------------------------------

struct Reliability
{
  std::int64_t Picks = 0;
  double Confidence = 0.0; // sum
  std::int64_t Right = 0; // within half a period
  std::int64_t Absent = 0;
};

constexpr std::array<double, 6> ConfidenceBins = { 0.0, 0.3, 0.5, 0.7, 0.9, 1.0 };

void AddPicks(const LatticeHorizon& surface, const std::vector<double>& misses, std::vector<Reliability>& bins)
{
  const HeapArray<double>& confidence = surface.Attributes.front().second;
  const HeapArray<int>& origins = surface.Labels.front().second;
  for (std::size_t n = 0; n < misses.size(); ++n)
  {
    const auto bin = std::upper_bound(ConfidenceBins.begin() + 1, ConfidenceBins.end() - 1, confidence[n]);
    Reliability& own = bins[std::size_t(bin - ConfidenceBins.begin()) - 1];
    if (PickOrigin(origins[n]) != PickOrigin::Guide)
    {
      ++own.Picks;
      own.Confidence += confidence[n];
      own.Right += misses[n] <= 1.0 ? 1 : 0;
      own.Absent += std::isinf(misses[n]) ? 1 : 0;
    }
  }
}

void PrintReliability(const std::string& name, const std::vector<Reliability>& bins)
{
  std::int64_t all = 0;
  std::for_each(bins.begin(), bins.end(), [&all](const Reliability& bin) { all += bin.Picks; });
  std::printf("| %s |", name.c_str());
  for (const Reliability& bin : bins)
  {
    const auto picks = double(std::max<std::int64_t>(1, bin.Picks));
    const auto present = double(std::max<std::int64_t>(1, bin.Picks - bin.Absent));
    std::printf(" %.1f: %.0f/%.0f/%.1f |", 100.0 * bin.Picks / double(all), 100.0 * bin.Confidence / picks,
      100.0 * bin.Right / picks, 100.0 * double(bin.Picks - bin.Absent - bin.Right) / present);
  }
  std::printf("\n");
  std::fflush(stdout);
}

void PrintConfidenceTable(int cubes)
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  std::printf("| picks, noise |");
  for (std::size_t bin = 1; bin < ConfidenceBins.size(); ++bin)
  {
    std::printf(" %.1f to %.1f |", ConfidenceBins[bin - 1], ConfidenceBins[bin]);
  }
  std::printf("\n| --- | --- | --- | --- | --- | --- |\n");
  for (const GuidedPlan& plan : { GuidedPlans[0], GuidedPlans[1], GuidedPlans[4] })
  {
    for (const double noise : GuidedNoises)
    {
      std::vector<Reliability> bins(ConfidenceBins.size() - 1);
      for (const CubeGenerator& cube : MakeWildCubes(cubes, noise))
      {
        const std::vector<LatticeHorizon> surfaces =
          ExtractGuided(cube, options, MakeGuides(cube, plan.Picks, cube.Options().Seed));
        for (std::size_t n = 0; n < surfaces.size(); ++n)
        {
          if (!surfaces[n].Column.empty())
          {
            AddPicks(surfaces[n], MeasureMisses(cube, int(n), surfaces[n]), bins);
          }
        }
      }
      PrintReliability(plan.Name + ", " + std::to_string(int(100.0 * noise)) + " %", bins);
    }
  }
}

/// How many of the first surfaces are main reflectors, by each order.
void PrintOrders(int cubes)
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.LargestNumber = 1000000;
  std::printf(
    "\nOf the first 20 surfaces, number on a reflector or a channel's floor; the others are on side lobes:\n\n"
    "| order |");
  for (const double noise : GuidedNoises)
  {
    std::printf(" noise %.0f %% |", 100.0 * noise);
  }
  std::printf("\n| --- | --- | --- | --- |\n");
  for (const SurfaceOrder order : { SurfaceOrder::Strength, SurfaceOrder::Size })
  {
    options.Order = order;
    std::printf("| %s |", order == SurfaceOrder::Strength ? "strength" : "size");
    for (const double noise : GuidedNoises)
    {
      int found = 0;
      for (const CubeGenerator& cube : MakeWildCubes(cubes, noise))
      {
        constexpr std::size_t first = 20;
        found += CountMain(cube, Extract(cube, options).Surfaces, first);
      }
      std::printf(" %.1f |", double(found) / cubes);
    }
    std::printf("\n");
  }
}

constexpr const char* Head = R"(# How much is found

What [Seismic Reflection Extraction](SeismicReflectionExtraction.md) finds of the known reflectors of generated cubes
(`generate_cube`) with its defaults. Components have the settings of the thesis: `Position` Middle,
`AmplitudePercentile` 70, `Connectivity` Eight and `LargestStep` 1. Made by `ReflectionStudy`, with cubes that no
constant of the method was chosen by.

- *found*: columns of all reflectors in the best surface of each, per side of the fault; *weakest*: the same of the
  weakest reflector of each cube, mean of the cubes;
- *wrong*: picks of best surfaces a quarter of a period or more off the reflector, or where it is absent;
- *leak*: picks of surfaces of 200 or more on the side of the fault where the surface has fewer;
- *error*: median, in samples; *surfaces*: surfaces of 10 picks or more per reflector, at least two, as the fault cuts
  each.
)";

constexpr const char* Easy = R"(## Easy cubes

Both ways of joining find nearly everything. The worst of no noise and 50 %% noise, %d cubes of 80 x 64 traces of 220
samples, with layers 32 samples apart, folds, and a fault of half a layer; Ricker wavelet of 30 Hz, 4 ms.
)";

constexpr const char* Hard = R"(## Hard cubes

Best First links few wrong picks, Components many. %d cubes of the same size: layers of 1.3 to 3.5 periods that fade to
0.12 of their strength, a fault of 0.25 to 3.25 periods, a channel, dead and missing traces, wavelets of 25 to 38 Hz.
Where a layer fades to noise, or forms one wavelet with a neighbour, nothing can be found.
)";

constexpr const char* Leak = R"(## Leak over the fault, by its throw

Throws below a fifth of a period look like a dip; above, Best First leaks least. Percent, %d hard cubes each; P is the
period of the wavelet.
)";

constexpr const char* Guided = R"(## Guided

Five picks per piece find most of a horizon, even with some wrong picks. %d wild cubes (`generate_cube --wild`) of 110 x
96 traces of 280 samples: difficult cubes with an unconformity, two channels, and one to four short faults; half of the
noise is in band, a quarter white, and a quarter dipping waves. *Picks* are random in each piece of a reflector (100 or
more connected columns), or all of every 20th line. Entries in percent: *found* / *weakest* / *off*, picks more than
half a period away / *absent*, picks where the reflector is not. Without picks the surface is the best one of each
piece. The plain tracker, a peer with the same picks that is given the true period, grows from these alone, best
correlation first.
)";

constexpr const char* Confidence = R"(
## Confidence

The array `Confidence` of guided horizons on the same cubes, in bins. Entries in percent: of all points, those in the
bin: their mean confidence / those within half a period of the reflector / *off*, where the reflector is.

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
  std::printf(Guided, wildCubes);
  std::printf("\n");
  PrintGuidedTable(wildCubes);
  PrintOrders(wildCubes);
  std::printf(Confidence);
  PrintConfidenceTable(wildCubes);
  return EXIT_SUCCESS;
}
