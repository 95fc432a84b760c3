// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the faults of generated horizons is found, and how much where there is none, by throw, over noise and
// dip. Prints the page Documentation/FaultTables.md:
//
//   FaultStudy [HORIZONS] > Documentation/FaultTables.md      HORIZONS of each kind; without it 4

#include "Faults/FaultDetection.h"
#include "Generator/FaultGenerator.h"
#include "Tools/FaultScore.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
// Horizons that no constant was chosen by have seeds from here on.
constexpr std::uint64_t FirstSeed = 1000;

const std::vector<double> Throws = { 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 40.0 };

struct Method
{
  std::string Name;
  FaultDetectionOptions Options;
};

std::vector<Method> ListMethods()
{
  std::vector<Method> methods(2);
  methods[0].Name = "Defaults";
  methods[1].Name = "SmallestThrow 2, SmallestExtent 8, SmallestBranch 6";
  methods[1].Options.SmallestThrow = 2.0;
  methods[1].Options.SmallestExtent = 8;
  methods[1].Options.SmallestBranch = 6;
  return methods;
}

FaultScore ScoreHorizons(int horizons, const FaultDetectionOptions& options, FaultGeneratorOptions made)
{
  FaultScore total;
  for (const double largest : made.NumberOfFaults > 0 ? Throws : std::vector<double>{ 0.0 })
  {
    for (int n = 0; n < horizons; ++n)
    {
      made.Throw = largest;
      made.Seed = FirstSeed + std::uint64_t(n) + 100 * std::uint64_t(largest);
      const FaultedHorizon horizon = MakeFaultedHorizon(made);
      const FaultDetection found = DetectFaults(ColumnHeights(horizon.Columns, horizon.Height), options);
      total.Add(ScoreFaults(horizon, found.Lines, int(std::ceil(0.5 * made.GapWidth))));
    }
  }
  return total;
}

void PrintScore(const FaultScore& score, bool isFaulted)
{
  if (isFaulted)
  {
    std::printf(" %.0f/%.0f/%.0f/%.0f, %.2f |", score.FoundPercent(0), score.FoundPercent(1), score.FoundPercent(2),
      score.FoundPercent(3), score.FalsePerThousand());
  }
  else
  {
    std::printf(" %lld |", static_cast<long long>(score.False));
  }
  std::fflush(stdout);
}

struct Kind
{
  std::string Name;
  FaultGeneratorOptions Options;
};

std::vector<Kind> ListKinds()
{
  std::vector<Kind> kinds(4);
  kinds[0].Name = "side to side";
  kinds[1].Name = "tapered";
  kinds[1].Options.AreTapered = true;
  kinds[2].Name = "tapered, crossed";
  kinds[2].Options.AreTapered = true;
  kinds[2].Options.AreCrossed = true;
  kinds[3].Name = "none";
  kinds[3].Options.NumberOfFaults = 0;
  return kinds;
}

const std::vector<double> Noises = { 0.0, 0.1, 0.3, 0.5, 1.0 };

void PrintHead(int horizons)
{
  std::printf(
    "# Faults found\n\n"
    "Made by `FaultStudy`. Each entry is the share of cut links that [Horizon Faults](HorizonFaults.md) finds,\n"
    "in %% by their throw of 1 to 2, 2 to 4, 4 to 8 and 8 or more vertical indices, and the number of false links\n"
    "for 1,000 columns: those more than a column off all that are torn. Where there are no faults it is the number\n"
    "of all false links. Each is from %d horizons of 200 by 200 columns with largest throws of 2, 3, 5, 8, 12, 20\n"
    "and 40 each, four faults on each, or eight that cross; `nan` where no link has such a throw. Noise is its\n"
    "standard deviation, and dip in vertical indices per column.\n",
    horizons);
}

void PrintNoiseTable(int horizons, const Method& method)
{
  std::printf("| faults | heights | dip |");
  for (const double noise : Noises)
  {
    std::printf(" noise %g |", noise);
  }
  std::printf("\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (Kind kind : ListKinds())
  {
    for (const bool areWhole : { true, false })
    {
      for (const double dip : { 0.5, 2.0 })
      {
        std::printf("| %s | %s | %g |", kind.Name.c_str(), areWhole ? "whole" : "real", dip);
        for (const double noise : Noises)
        {
          kind.Options.AreHeightsWhole = areWhole;
          kind.Options.Dip = dip;
          kind.Options.Noise = noise;
          PrintScore(ScoreHorizons(horizons, method.Options, kind.Options), kind.Options.NumberOfFaults > 0);
        }
        std::printf("\n");
      }
    }
  }
  std::printf("\n");
}

void PrintGapTable(int horizons, const Method& method)
{
  std::printf("| gap | noise 0 | noise 0.3 | noise 1 |\n| --- | --- | --- | --- |\n");
  for (const double width : { 1.0, 2.0, 3.0, 4.0 })
  {
    std::printf("| %g columns |", width);
    for (const double noise : { 0.0, 0.3, 1.0 })
    {
      FaultGeneratorOptions options;
      options.AreTapered = true;
      options.GapWidth = width;
      options.Noise = noise;
      PrintScore(ScoreHorizons(horizons, method.Options, options), true);
    }
    std::printf("\n");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int horizons = argc > 1 ? std::atoi(argv[1]) : 4;
  PrintHead(horizons);
  for (const Method& method : ListMethods())
  {
    std::printf("\n## %s\n\n", method.Name.c_str());
    PrintNoiseTable(horizons, method);
    std::printf("\nGaps along tapered faults, dip 0.5, whole heights:\n\n");
    PrintGapTable(horizons, method);
  }
  return EXIT_SUCCESS;
}
