// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuidedStudy.h"

#include "GuidedTexts.h"
#include "PlainTracker.h"
#include "Tools/GuideScore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Cubes that no constant was chosen by have seeds from here on.
constexpr std::uint64_t FirstWildSeed = 2000;

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
  std::copy_if(
    guides.begin(), guides.end(), std::back_inserter(given), [](const Guide& guide) { return !guide.Picks.empty(); });
  std::vector<LatticeHorizon> found = ExtractFrom(cube, options, given).Surfaces;
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

const std::vector<double> GuidedNoises = { 0.0, 0.2, 0.5 };

ExtractionOptions TakeAll()
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  options.LargestNumber = 1000000;
  return options;
}

/// With options that change(options) sets.
template <typename Change>
std::vector<CubeGenerator> MakeWildCubes(int cubes, Change&& change)
{
  std::vector<CubeGenerator> generators;
  for (int n = 0; n < cubes; ++n)
  {
    CubeGeneratorOptions wild = WildCube(FirstWildSeed + std::uint64_t(n));
    change(wild);
    generators.emplace_back(wild);
  }
  return generators;
}

std::vector<CubeGenerator> MakeNoisyCubes(int cubes, double noise)
{
  return MakeWildCubes(cubes,
    [noise](CubeGeneratorOptions& wild)
    {
      wild.NoiseFraction = noise;
      wild.Noise = NoiseKind::Mixed;
    });
}

/// An entry of a table: `score` gives that of a cube.
template <typename Score>
void PrintScore(const std::vector<CubeGenerator>& cubes, Score&& score)
{
  GuideScore total;
  double weakest = 0.0;
  for (const CubeGenerator& cube : cubes)
  {
    const GuideScore one = score(cube);
    total.Add(one);
    weakest += one.Weakest / double(cubes.size());
  }
  std::printf(
    " %.1f/%.1f/%.1f/%.1f |", 100.0 * total.Found(), 100.0 * weakest, 100.0 * total.Off(), 100.0 * total.Absent());
  std::fflush(stdout);
}

template <typename Score>
void PrintGuidedRow(const std::string& name, const std::vector<std::vector<CubeGenerator>>& byNoise, Score&& score)
{
  std::printf("| %s |", name.c_str());
  for (const std::vector<CubeGenerator>& cubes : byNoise)
  {
    PrintScore(cubes, score);
  }
  std::printf("\n");
}

GuideScore ScorePlan(const CubeGenerator& cube, const ExtractionOptions& options, const GuidedPlan& plan)
{
  return ScoreGuided(cube, ExtractGuided(cube, options, MakeGuides(cube, plan.Picks, cube.Options().Seed)));
}

GuideScore ScorePlainly(const CubeGenerator& cube, const GuidedPlan& plan)
{
  const std::vector<float> traces = cube.MakeTraces();
  const double period = 1000.0 / (cube.Options().Frequency * cube.Options().SampleInterval);
  std::vector<LatticeHorizon> surfaces;
  for (const Guide& guide : MakeGuides(cube, plan.Picks, cube.Options().Seed))
  {
    surfaces.push_back(TrackPlainly(traces, cube.Options().Size, period, guide));
  }
  return ScoreGuided(cube, surfaces);
}

void PrintGuidedTable(int cubes)
{
  ExtractionOptions options = TakeAll();
  std::printf("| picks |");
  for (const double noise : GuidedNoises)
  {
    std::printf(" noise %.0f %% |", 100.0 * noise);
  }
  std::printf("\n| --- | --- | --- | --- |\n");
  std::vector<std::vector<CubeGenerator>> byNoise;
  for (const double noise : GuidedNoises)
  {
    byNoise.push_back(MakeNoisyCubes(cubes, noise));
  }
  PrintGuidedRow("none", byNoise,
    [&](const CubeGenerator& cube) { return ScoreUnguided(cube, ExtractFrom(cube, options).Surfaces); });
  for (const GuidedPlan& plan : GuidedPlans)
  {
    PrintGuidedRow(plan.Name, byNoise, [&](const CubeGenerator& cube) { return ScorePlan(cube, options, plan); });
    PrintGuidedRow("- plain tracker", byNoise, [&](const CubeGenerator& cube) { return ScorePlainly(cube, plan); });
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

std::vector<Reliability> MeasureReliability(const std::vector<CubeGenerator>& cubes, const GuidedPlan& plan)
{
  ExtractionOptions options;
  options.SmallestSize = 10;
  std::vector<Reliability> bins(ConfidenceBins.size() - 1);
  for (const CubeGenerator& cube : cubes)
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
  return bins;
}

void PrintBins(const char* rows)
{
  std::printf("| %s |", rows);
  for (std::size_t bin = 1; bin < ConfidenceBins.size(); ++bin)
  {
    std::printf(" %.1f to %.1f |", ConfidenceBins[bin - 1], ConfidenceBins[bin]);
  }
  std::printf("\n| --- | --- | --- | --- | --- | --- |\n");
}

void PrintConfidenceTable(int cubes)
{
  PrintBins("picks, noise");
  for (const GuidedPlan& plan : { GuidedPlans[0], GuidedPlans[1], GuidedPlans[4] })
  {
    for (const double noise : GuidedNoises)
    {
      PrintReliability(plan.Name + ", " + std::to_string(int(100.0 * noise)) + " %",
        MeasureReliability(MakeNoisyCubes(cubes, noise), plan));
    }
  }
}

/// How many of the first surfaces are main reflectors, by each order.
void PrintOrders(int cubes)
{
  ExtractionOptions options = TakeAll();
  std::printf(
    "\nNumber of the first 20 surfaces that are on a reflector or a channel floor; the others are on side lobes:\n\n"
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
      for (const CubeGenerator& cube : MakeNoisyCubes(cubes, noise))
      {
        constexpr std::size_t first = 20;
        found += CountMain(cube, ExtractFrom(cube, options).Surfaces, first);
      }
      std::printf(" %.1f |", double(found) / cubes);
    }
    std::printf("\n");
  }
}

// ---- Fine sampling -------------------------------------------------------------------------------------------------

void PrintSamplingTable(int cubes)
{
  ExtractionOptions options = TakeAll();
  std::printf("| samples, picks | noise 0 %% | noise 25 %% | noise 50 %% |\n| --- | --- | --- | --- |\n");
  for (const double times : { 1.0, 1.7, 3.3 })
  {
    std::vector<std::vector<CubeGenerator>> byNoise;
    for (const double noise : { 0.0, 0.25, 0.5 })
    {
      byNoise.push_back(MakeWildCubes(cubes,
        [noise, times](CubeGeneratorOptions& wild)
        {
          wild.Size = { 70, 60, wild.Size[2] };
          wild.NoiseFraction = noise;
          wild = SampleFinely(wild, times);
        }));
    }
    const std::string name = std::to_string(times).substr(0, 3) + " times, ";
    PrintGuidedRow(name + "none", byNoise,
      [&](const CubeGenerator& cube) { return ScoreUnguided(cube, ExtractFrom(cube, options).Surfaces); });
    PrintGuidedRow(name + GuidedPlans[1].Name, byNoise,
      [&](const CubeGenerator& cube) { return ScorePlan(cube, options, GuidedPlans[1]); });
  }
}

// ---- Troubles ------------------------------------------------------------------------------------------------------

/// By the name of the trouble.
std::map<std::string, std::vector<CubeGenerator>> MakeTroubledCubes(int cubes)
{
  std::map<std::string, std::set<Trouble>> rows = { { "(none)", {} } };
  for (const auto& [name, trouble] : TroubleNames())
  {
    rows[name] = { trouble };
  }
  std::map<std::string, std::vector<CubeGenerator>> troubled;
  for (const auto& [name, troubles] : rows)
  {
    troubled[name] = MakeWildCubes(cubes,
      [own = troubles](CubeGeneratorOptions& wild)
      {
        wild.Size = { 90, 80, wild.Size[2] };
        wild.NoiseFraction = 0.25;
        wild.Noise = NoiseKind::Lateral;
        wild.Troubles = own;
      });
  }
  return troubled;
}

void PrintTroubleTable(int cubes)
{
  ExtractionOptions options = TakeAll();
  std::printf("| trouble | no picks | 1 pick | 5 picks | 20 picks |\n| --- | --- | --- | --- | --- |\n");
  for (const auto& [name, generators] : MakeTroubledCubes(cubes))
  {
    std::printf("| %s |", name.c_str());
    PrintScore(
      generators, [&](const CubeGenerator& cube) { return ScoreUnguided(cube, ExtractFrom(cube, options).Surfaces); });
    const std::array<GuidedPlan, 3> plans = { GuidedPlans[0], GuidedPlans[1], GuidedPlans[4] };
    for (const GuidedPlan& plan : plans)
    {
      PrintScore(generators, [&](const CubeGenerator& cube) { return ScorePlan(cube, options, plan); });
    }
    std::printf("\n| - plain tracker | |");
    for (const GuidedPlan& plan : plans)
    {
      PrintScore(generators, [&](const CubeGenerator& cube) { return ScorePlainly(cube, plan); });
    }
    std::printf("\n");
  }
}

void PrintConfidenceOfTroubles(int cubes)
{
  std::printf("\nTheir confidence with five picks, as under *Confidence*:\n\n");
  PrintBins("trouble");
  for (const auto& [name, generators] : MakeTroubledCubes(cubes))
  {
    PrintReliability(name, MeasureReliability(generators, GuidedPlans[1]));
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
Extraction ExtractFrom(const CubeGenerator& cube, const ExtractionOptions& options, const std::vector<Guide>& guides)
{
  const std::vector<float> traces = cube.MakeTraces();
  const std::array<int, 3>& size = cube.Options().Size;
  StridedSamples<float> samples;
  samples.First = traces.data();
  samples.Strides = { size[2], std::ptrdiff_t(size[0]) * size[2], 1 };
  return ExtractReflections(MakeTraceCube(size, samples), options, Monitor(), guides);
}

//----------------------------------------------------------------------------------------------------------------------
void PrintGuidedStudy(int cubes)
{
  std::printf(GuidedText, cubes);
  std::printf("\n");
  PrintGuidedTable(cubes);
  PrintOrders(cubes);
  std::printf("%s", ConfidenceText);
  PrintConfidenceTable(cubes);
  std::printf("%s", SamplingText);
  PrintSamplingTable((cubes + 1) / 2);
  std::printf("%s", TroublesText);
  PrintTroubleTable((cubes + 1) / 2);
  PrintConfidenceOfTroubles((cubes + 1) / 2);
}
}
