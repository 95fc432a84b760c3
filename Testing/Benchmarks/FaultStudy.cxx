// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the faults of generated horizons is found, and how much where there is none, by throw, over noise and
// dip. Prints the page Documentation/FaultTables.md:
//
//   FaultStudy [HORIZONS] > Documentation/FaultTables.md      HORIZONS of each kind; without it 4

#include "Common/Horizon/LinkCuts.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Generator/FaultGenerator.h"
#include "Tools/FaultScore.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr std::uint64_t FirstSeed = 1000; // no constant was chosen by horizons with seeds from here on

const std::vector<double> Throws = { 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 40.0 };

struct Method
{
  std::string Name;
  std::vector<double> Dips;
  FaultDetectionOptions Options;
};

std::vector<Method> ListMethods()
{
  std::vector<Method> methods(2);
  methods[0].Name = "Defaults";
  methods[0].Dips = { 0.5 };
  methods[1].Name = "SmallestThrow 2, SmallestExtent 8, SmallestBranch 6";
  methods[1].Dips = { 0.5, 2.0 };
  methods[1].Options.SmallestThrow = 2.0;
  methods[1].Options.SmallestExtent = 8;
  methods[1].Options.SmallestBranch = 6;
  return methods;
}

FaultScore ScoreHorizons(
  int horizons, const FaultDetectionOptions& options, FaultGeneratorOptions made, int reachOfAll = 0)
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
      total.Add(ScoreFaults(horizon, found.Lines, int(std::ceil(0.5 * made.GapWidth)), reachOfAll));
    }
  }
  return total;
}

void PrintScore(const FaultScore& score)
{
  std::printf(" %.0f/%.0f/%.0f/%.0f, %.2f |", score.FoundPercent(0), score.FoundPercent(1), score.FoundPercent(2),
    score.FoundPercent(3), score.FalsePerThousand());
  std::fflush(stdout);
}

struct Kind
{
  std::string Name;
  FaultGeneratorOptions Options;
};

std::vector<Kind> ListKinds()
{
  std::vector<Kind> kinds(3);
  kinds[0].Name = "side to side";
  kinds[1].Name = "tapered";
  kinds[1].Options.AreTapered = true;
  kinds[2].Name = "tapered, crossed";
  kinds[2].Options.AreTapered = true;
  kinds[2].Options.AreCrossed = true;
  return kinds;
}

const std::vector<double> Noises = { 0.3, 1.0 };

void PrintHead(int horizons)
{
  std::printf(
    "# Faults found\n\n"
    "These tables show how well [Horizon Faults](HorizonFaults.md) detects the faults of synthetic horizons, with its\n"
    "defaults and with lower thresholds. `FaultStudy` measures and writes this page.\n\n"
    "Entries are the percentages of faulted edges found with throws of 1 to 2, 2 to 4, 4 to 8, and 8 or more\n"
    "vertical indices, then the number of false edges per 1,000 columns: edges more than a column from all faults.\n"
    "For each of the largest throws 2, 3, 5, 8, 12, 20 and 40 there are %d horizons of 200 by 200 columns with four\n"
    "faults, or eight if they cross. `nan`: no edge has such a throw. Noise is its standard deviation; dip is in\n"
    "vertical indices per column.\n",
    horizons);
}

void PrintNoiseTable(int horizons, const Method& method)
{
  std::printf("| faults | heights | dip |");
  for (const double noise : Noises)
  {
    std::printf(" noise %g |", noise);
  }
  std::printf("\n| --- | --- | --- | --- | --- |\n");
  for (Kind kind : ListKinds())
  {
    for (const bool areWhole : { true, false })
    {
      for (const double dip : method.Dips)
      {
        std::printf("| %s | %s | %g |", kind.Name.c_str(), areWhole ? "whole" : "real", dip);
        for (const double noise : Noises)
        {
          kind.Options.AreHeightsWhole = areWhole;
          kind.Options.Dip = dip;
          kind.Options.Noise = noise;
          PrintScore(ScoreHorizons(horizons, method.Options, kind.Options));
        }
        std::printf("\n");
      }
    }
  }
  std::printf("\n");
}

constexpr int RampReach = 2; // how far from a fault that bends the surface a link that was found may be

/// Tapered faults at which columns are missing, that bend the surface, or of picks on some rows alone.
void PrintShapeTable(int horizons, const Method& method)
{
  std::printf("| tapered faults | noise 0.3 | noise 1 |\n| --- | --- | --- |\n");
  const auto print = [&](const std::string& shape, FaultGeneratorOptions options, int reach)
  {
    std::printf("| %s |", shape.c_str());
    for (const double noise : Noises)
    {
      options.AreTapered = true;
      options.Noise = noise;
      PrintScore(ScoreHorizons(horizons, method.Options, options, reach));
    }
    std::printf("\n");
  };
  for (const int width : { 1, 3, 4 })
  {
    FaultGeneratorOptions options;
    options.GapWidth = width;
    print("gap of " + std::to_string(width), options, 0);
  }
  for (const int width : { 2, 4, 7 })
  {
    FaultGeneratorOptions options;
    options.RampWidth = width;
    print("ramp of " + std::to_string(width), options, RampReach);
  }
  FaultGeneratorOptions options;
  options.PickSpacing = 5;
  print("picks on every 5th row", options, RampReach);
}

/// Folds twice as high as the dip, without faults: the most false edges for 1,000 columns.
double ScoreFolds(int horizons, const Method& method)
{
  double most = 0.0;
  for (const bool areWhole : { true, false })
  {
    for (const double dip : { 0.5, 2.0 })
    {
      for (const double noise : Noises)
      {
        FaultGeneratorOptions options;
        options.NumberOfFaults = 0;
        options.Fold = 2.0;
        options.AreHeightsWhole = areWhole;
        options.Dip = dip;
        options.Noise = noise;
        most = std::max(most, ScoreHorizons(4 * horizons, method.Options, options).FalsePerThousand());
      }
    }
  }
  return most;
}

/// Adds the squares of the errors of the heights that a hole is filled with.
class FillErrors
{
public:
  void Add(const FaultedHorizon& horizon, const FaultedHorizon& whole, const LinkCuts& cuts)
  {
    HoleFillingOptions options;
    options.LargestHoleSize = std::int64_t(whole.Columns.size());
    const FilledColumns filled = FillHoles(horizon.Columns, horizon.Height, {}, options, &cuts);
    const int size = whole.Columns.back().X + 1;
    for (std::size_t n = 0; n < filled.Column.size(); ++n)
    {
      const double truth = whole.Height[std::size_t(filled.Column[n].Y * size + filled.Column[n].X)];
      this->Sum += (filled.Height[n] - truth) * (filled.Height[n] - truth);
      ++this->Columns;
    }
  }

  double RootMeanSquare() const { return std::sqrt(this->Sum / double(this->Columns)); }

private:
  double Sum = 0.0;
  std::int64_t Columns = 0;
};

void Cut(LinkCuts& cuts, const PlanePoint& column, bool isNorth)
{
  isNorth ? cuts.CutNorth(column) : cuts.CutEast(column);
}

/// The torn links both columns of which are in the hole.
std::vector<TornLink> TornInHole(const FaultedHorizon& horizon, const FaultGeneratorOptions& made)
{
  const PlanePoint first{ (made.Size - made.HoleSize) / 2, (made.Size - made.HoleSize) / 2 };
  const PlaneBox hole({ first, { first.X + made.HoleSize - 1, first.Y + made.HoleSize - 1 } });
  std::vector<TornLink> torn;
  for (const TornLink& link : horizon.Torn)
  {
    if (hole.Contains(link.Column) &&
      hole.Contains({ link.Column.X + (link.IsNorth ? 0 : 1), link.Column.Y + (link.IsNorth ? 1 : 0) }))
    {
      torn.push_back(link);
    }
  }
  return torn;
}

/// Straight down through each `spacing`th of the links that a fault tears, in no order. The one in the middle may end
/// short.
std::vector<FaultStick> MakeSticks(const FaultedHorizon& horizon, std::size_t spacing, bool endsShort)
{
  constexpr double Top = -1000.0;
  constexpr double Bottom = 1000.0;
  std::vector<FaultStick> sticks;
  std::vector<SpacePoint> places; // in the order along the fault, which is about straight
  for (const TornLink& link : horizon.Torn)
  {
    places.push_back({ link.Column.X + (link.IsNorth ? 0.0 : 0.5), link.Column.Y + (link.IsNorth ? 0.5 : 0.0), 0.0 });
  }
  const auto ends = std::minmax_element(
    places.begin(), places.end(), [](const SpacePoint& a, const SpacePoint& b) { return a.X < b.X; });
  const bool isAlongX = ends.second->X - ends.first->X > 100.0;
  std::sort(places.begin(), places.end(),
    [isAlongX](const SpacePoint& a, const SpacePoint& b) { return isAlongX ? a.X < b.X : a.Y < b.Y; });
  for (std::size_t n = 0; n < places.size(); n += spacing)
  {
    const bool isShort = endsShort && n == places.size() / spacing / 2 * spacing;
    const double bottom = isShort ? Top + 1.0 : Bottom;
    sticks.push_back({ { { places[n].X, places[n].Y, Top }, { places[n].X, places[n].Y, bottom } }, "F" });
  }
  sticks.push_back(
    { { { places.back().X, places.back().Y, Top }, { places.back().X, places.back().Y, Bottom } }, "F" });
  std::mt19937 random(7);
  std::shuffle(sticks.begin(), sticks.end(), random);
  return sticks;
}

/// The least part that is found, and the most false edges, over sticks at 5 to 60 edges, of which one may be short.
void PrintSticks(int horizons)
{
  double found = 100.0;
  double wrong = 0.0;
  for (const std::size_t spacing : { 5, 20, 60 })
  {
    for (const bool endsShort : { false, true })
    {
      FaultScore total;
      for (int n = 0; n < horizons; ++n)
      {
        FaultGeneratorOptions made;
        made.NumberOfFaults = 1;
        made.Seed = FirstSeed + std::uint64_t(n);
        const FaultedHorizon horizon = MakeFaultedHorizon(made);
        const ColumnHeights heights(horizon.Columns, horizon.Height);
        const auto sheets = MakeFaultSheets(MakeSticks(horizon, spacing, endsShort), false);
        total.Add(ScoreFaults(horizon, CutAlong(heights, FindTraces(heights, sheets)), 0, RampReach));
      }
      found = std::min(found, total.FoundPercent(3));
      wrong = std::max(wrong, total.FalsePerThousand());
    }
  }
  std::printf(
    "For a fault from side to side with a stick every 5 to 60 edges, in any order, at least %.0f %% of the edges are\n"
    "cut within two columns, and at most %.2f per 1,000 columns elsewhere. Noise 0.3.\n",
    found, wrong);
}

void PrintHoleTable(int horizons, const Method& method)
{
  std::printf("| hole | found | error without cuts | with cuts found | with all cuts |\n"
              "| --- | --- | --- | --- | --- |\n");
  for (const int size : { 10, 40, 80 })
  {
    FaultScore score;
    FillErrors plain, withFound, withAll;
    for (const double largest : { 8.0, 12.0, 20.0, 40.0 })
    {
      for (int n = 0; n < horizons; ++n)
      {
        FaultGeneratorOptions made;
        made.NumberOfFaults = 1;
        made.Noise = 0.3;
        made.Throw = largest;
        made.Seed = FirstSeed + std::uint64_t(n) + 100 * std::uint64_t(largest);
        const FaultedHorizon whole = MakeFaultedHorizon(made);
        made.HoleSize = size;
        FaultedHorizon horizon = MakeFaultedHorizon(made);
        const FaultDetection found = DetectFaults(ColumnHeights(horizon.Columns, horizon.Height), method.Options);
        LinkCuts cuts(PlaneBox({ { 0, 0 }, { made.Size - 1, made.Size - 1 } }));
        plain.Add(horizon, whole, cuts);
        LinkCuts foundCuts = cuts;
        for (std::size_t link = 0; link < found.Lines.NumberOfLinks(); ++link)
        {
          Cut(foundCuts, found.Lines[link].Place.Column, found.Lines[link].Place.Side == LinkSide::North);
        }
        withFound.Add(horizon, whole, foundCuts);
        for (const TornLink& link : horizon.Torn)
        {
          Cut(cuts, link.Column, link.IsNorth);
        }
        withAll.Add(horizon, whole, cuts);
        const std::int64_t falseLinks = ScoreFaults(horizon, found.Lines, RampReach).False;
        horizon.Torn = TornInHole(horizon, made);
        FaultScore one = ScoreFaults(horizon, found.Lines, RampReach);
        one.False = falseLinks;
        score.Add(one);
      }
    }
    std::printf("| %d x %d | %.0f, %.2f | %.2f | %.2f | %.2f |\n", size, size, score.FoundPercent(3),
      score.FalsePerThousand(), plain.RootMeanSquare(), withFound.RootMeanSquare(), withAll.RootMeanSquare());
    std::fflush(stdout);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int horizons = argc > 1 ? std::atoi(argv[1]) : 4;
  PrintHead(horizons);
  const std::vector<Method> methods = ListMethods();
  for (const Method& method : methods)
  {
    std::printf("\n## %s\n\n", method.Name.c_str());
    PrintNoiseTable(horizons, method);
    std::printf(
      "Dip 0.5, whole heights, widths in columns; found within two columns at ramps and on sparse rows:\n\n");
    PrintShapeTable(horizons, method);
    if (&method != &methods.front())
    {
      continue;
    }
    std::printf("\nFolds twice as high as the dip, without faults, have at most %.2f false edges per 1,000 columns.\n",
      ScoreFolds(horizons, method));
    std::printf(
      "\nA fault with a throw of at least 8 crosses a hole: percentage of its edges in the hole found within two\n"
      "columns, false edges per 1,000 columns, and rms errors of the filled heights; noise 0.3:\n\n");
    PrintHoleTable(horizons, method);
  }
  std::printf("\n## Sticks\n\n");
  PrintSticks(horizons);
  return EXIT_SUCCESS;
}
