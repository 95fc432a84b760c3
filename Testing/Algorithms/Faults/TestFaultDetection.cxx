// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults are found where they are: exactly without noise, nearly all with some, none where there is none.

#include "Common/Base/Parallel.h"
#include "FaultPictures.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Generator/FaultGenerator.h"
#include "Tools/Check.h"
#include "Tools/FaultScore.h"
#include "Tools/Patches.h"

#include <limits>

using namespace SeismicHorizons;

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

FaultDetection Detect(const FaultedHorizon& horizon, const FaultDetectionOptions& options = {})
{
  return DetectFaults(ColumnHeights(horizon.Columns, horizon.Height), options);
}

FaultDetectionOptions Sensitive()
{
  FaultDetectionOptions options;
  options.SmallestThrow = 2.0;
  options.SmallestExtent = 8;
  options.SmallestBranch = 6;
  return options;
}

void FindsAStepExactly()
{
  // Dip of 2 to the east, a step of 7 between the columns 14 and 15.
  const FaultDetection found =
    DetectFaults(MakeHeights(30, 25, [](int i, int) { return 2.0 * i + (i > 14 ? 7.0 : 0.0); }), {});
  CHECK_EQUAL(found.Lines.Size(), 1U);
  CHECK_EQUAL(found.Lines.NumberOfLinks(), 25U);
  for (std::size_t n = 0; n < found.Lines.NumberOfLinks(); ++n)
  {
    const FaultedLink& link = found.Lines[n];
    CHECK_EQUAL(ToText(link.Place), "E(14," + std::to_string(link.Place.Column.Y) + ")");
    CHECK_EQUAL(link.Throw, 9.0);
    CHECK_EQUAL(link.LeftThrow(), 9.0);
    CHECK_EQUAL(link.Middle, 32.5);
  }
  CHECK(AreChains(found.Lines));
  CHECK_EQUAL(found.Noise, 0.408);
  CHECK_EQUAL(found.High, 4.0);
}

void NoiseIsMeasured()
{
  for (const bool areWhole : { true, false })
  {
    for (const double noise : { 0.3, 0.5, 1.0, 2.0 })
    {
      FaultGeneratorOptions options;
      options.Noise = noise;
      options.AreHeightsWhole = areWhole;
      options.NumberOfFaults = 0;
      const double truth = std::sqrt(2.0 * (noise * noise + (areWhole ? 1.0 / 12.0 : 0.0)));
      const double found = Detect(MakeFaultedHorizon(options)).Noise;
      CHECK(found > 0.95 * truth && found < 1.15 * truth);
    }
  }
  FaultDetectionOptions given;
  given.Noise = 3.0;
  const FaultDetection found = Detect(MakeFaultedHorizon({}), given);
  CHECK_EQUAL(found.Noise, 3.0);
  CHECK_EQUAL(found.Low, 7.5);
  CHECK_EQUAL(found.High, 12.0);
}

/// Noise as a survey leaves it, in every third file. Of many links only some are measured: all files alike, whatever
/// the width of the lattice is, so that the whole has the noise of a part all links of which are.
void NoiseInStripesIsMeasured()
{
  for (const int width : { 300, 301, 302 })
  {
    const auto measure = [width](int length)
    {
      Patches::Random random(5);
      return DetectFaults(
        MakeHeights(width, length, [&random](int i, int) { return (i % 3 == 1 ? 3.0 : 1.0) * random.Fraction(); }), {})
        .Noise;
    };
    const double ofPart = measure(800);
    const double ofWhole = measure(3500);
    CHECK(std::abs(ofWhole - ofPart) < 0.01 * ofPart);
  }
}

void FindsGeneratedFaults()
{
  for (const bool areWhole : { true, false })
  {
    for (const double dip : { 0.5, 2.0 })
    {
      FaultScore score;
      for (const double largest : { 5.0, 12.0, 40.0 })
      {
        FaultGeneratorOptions options;
        options.AreHeightsWhole = areWhole;
        options.Dip = dip;
        options.AreTapered = true;
        options.AreCrossed = true;
        options.Throw = largest;
        options.Seed = 77 + std::uint64_t(largest);
        const FaultedHorizon horizon = MakeFaultedHorizon(options);
        const FaultDetection found = Detect(horizon, Sensitive());
        CHECK(AreChains(found.Lines));
        score.Add(ScoreFaults(horizon, found.Lines, 0));
      }
      CHECK(score.FoundPercent(1) >= 93.0);
      CHECK(score.FoundPercent(2) >= 99.0);
      CHECK(score.FoundPercent(3) >= 99.0);
      CHECK(score.FalsePerThousand() < 0.5);
    }
  }
}

void FindsNothingWhereNothingIs()
{
  for (const bool areWhole : { true, false })
  {
    for (const double noise : { 0.0, 0.3, 1.0 })
    {
      for (const double dip : { 0.0, 0.5, 2.0 })
      {
        FaultGeneratorOptions options;
        options.NumberOfFaults = 0;
        options.AreHeightsWhole = areWhole;
        options.Noise = noise;
        options.Dip = dip;
        CHECK_EQUAL(Detect(MakeFaultedHorizon(options), Sensitive()).Lines.NumberOfLinks(), 0U);
      }
    }
  }
}

void BridgesGaps()
{
  // Three missing columns, in a band that shifts by one; the dip alone would lift the far side by 8.
  const auto height = [](int i, int j)
  {
    const int first = j < 15 ? 14 : 15;
    return i >= first && i < first + 3 ? Missing : 2.0 * i + (i >= first ? 6.0 : 0.0);
  };
  const FaultDetection found = DetectFaults(MakeHeights(32, 30, height), {});
  CHECK_EQUAL(found.Lines.Size(), 1U);
  CHECK(AreChains(found.Lines));
  CHECK_EQUAL(found.Lines.NumberOfLinks(), 31U); // a step in each row, and one aside
  for (std::size_t n = 0; n < found.Lines.NumberOfLinks(); ++n)
  {
    const FaultedLink& link = found.Lines[n];
    CHECK(link.Place.Side == LinkSide::North || std::abs(link.Throw - 6.0) < 1e-9);
    CHECK(link.Place.Column.X >= 13 && link.Place.Column.X <= 18);
  }
  FaultDetectionOptions narrow;
  narrow.LargestGap = 2;
  CHECK_EQUAL(DetectFaults(MakeHeights(32, 30, height), narrow).Lines.Size(), 0U);
  // The same band without a throw.
  const auto level = [](int i, int) { return i >= 14 && i < 17 ? Missing : 2.0 * i; };
  CHECK_EQUAL(DetectFaults(MakeHeights(32, 30, level), {}).Lines.Size(), 0U);
  // From a gap into links without one.
  const auto half = [](int i, int j) { return j < 15 && i >= 13 && i < 17 ? Missing : i >= 15 ? 6.0 : 0.0; };
  const FaultDetection both = DetectFaults(MakeHeights(32, 30, half), {});
  CHECK_EQUAL(both.Lines.Size(), 1U);
  CHECK(both.Lines.NumberOfLinks() >= 30U);
}

void SmallHorizonsHaveNoFaults()
{
  CHECK_EQUAL(DetectFaults(ColumnHeights({ { 3, 4 } }, { 5.0 }), {}).Lines.Size(), 0U);
  CHECK_EQUAL(DetectFaults(MakeHeights(40, 1, [](int i, int) { return i < 20 ? 0.0 : 9.0; }), {}).Lines.Size(), 0U);
  // Points far apart, nothing between them.
  CHECK_EQUAL(DetectFaults(ColumnHeights({ { 0, 0 }, { 300, 200 } }, { 5.0, 99.0 }), {}).Lines.Size(), 0U);
}

/// The noise, and the links that cut two equal parts with faults, the second of which begins at `second`, counted from
/// their part.
std::string CutsOfParts(const FaultedHorizon& part, const PlanePoint& second, int largestGap)
{
  std::vector<PlanePoint> columns = part.Columns;
  std::vector<double> heights = part.Height;
  for (std::size_t point = 0; point < part.Columns.size(); ++point)
  {
    columns.push_back({ part.Columns[point].X + second.X, part.Columns[point].Y + second.Y });
    heights.push_back(part.Height[point] + 30.0);
  }
  const ColumnHeights horizon(columns, heights);
  FaultDetectionOptions options;
  options.LargestGap = largestGap;
  options.JoinThroughHoles = false; // from part to part
  const FaultDetection found = DetectFaults(horizon, options);
  FaultLines lines = found.Lines;
  CHECK(AreChains(lines));
  // Along the diagonal of both parts, and from the first to the second.
  const double end = 199.5;
  lines.Append(CutAlong(horizon, { { { 0.5, 0.3 }, { end, end } }, { { 20.5, 180.3 }, { end, 180.3 } } }));
  lines.Append(CutAlong(horizon, { { { second.X + 0.5, second.Y + 0.3 }, { second.X + end, second.Y + end } } }));
  std::string text = std::to_string(found.Noise) + '\n';
  for (std::size_t n = 0; n < lines.NumberOfLinks(); ++n)
  {
    LatticeLink link = lines[n].Place;
    const bool isSecond = link.Column.X >= second.X && link.Column.Y >= second.Y;
    link.Column = isSecond ? PlanePoint{ link.Column.X - second.X, link.Column.Y - second.Y } : link.Column;
    text += ToText(link) + ' ' + std::to_string(lines[n].Throw) + ' ' + std::to_string(lines[n].Middle) + '\n';
  }
  return text;
}

/// Parts far apart give what they give near each other; a raster of all columns between would not fit memory.
void PartsFarApartAreFound()
{
  FaultGeneratorOptions options;
  options.GapWidth = 3.0;
  options.AreCrossed = true;
  const FaultedHorizon part = MakeFaultedHorizon(options);
  const std::string near = CutsOfParts(part, { 230, 250 }, 5);
  CHECK(near.size() > 1000U);
  for (const PlanePoint& second : { PlanePoint{ 3000, 250 }, { 230, 3000 }, { 300000, 1 << 28 } })
  {
    CHECK_EQUAL(CutsOfParts(part, second, 5), near);
  }
  // A band that is left out of the raster in part, which planes from both sides cross.
  const auto step = [](int i, int) { return i < 8 ? 1.0 : i < 2008 ? Missing : 9.0; };
  FaultDetectionOptions wide;
  wide.LargestGap = 2000;
  wide.SmallestExtent = 8;
  const FaultDetection found = DetectFaults(MakeHeights(2016, 16, step), wide);
  const FaultDetection same = DetectFaults(MakeHeights(2016, 1000, step), wide);
  CHECK_EQUAL(found.Lines.NumberOfLinks(), 16U);
  CHECK_EQUAL(ToText(found.Lines).substr(0, 19), "E(1007,0) E(1007,1)");
  CHECK_EQUAL(same.Lines.NumberOfLinks(), 1000U);
  CHECK_EQUAL(ToText(same.Lines).substr(0, 19), "E(1007,0) E(1007,1)");
  CHECK_EQUAL(same.Lines[3].Throw, found.Lines[3].Throw);
}

/// Ramps of 2 to 7 columns, and picks on each fifth row with straight lines between.
void FindsRamps()
{
  for (const int width : { 2, 3, 5, 7, 0 })
  {
    FaultScore score;
    FaultGeneratorOptions options;
    options.RampWidth = width;
    options.PickSpacing = width == 0 ? 5 : 1;
    for (const double largest : { 9.0, 12.0, 20.0 })
    {
      options.Throw = largest;
      options.Seed = 500 + std::uint64_t(largest);
      const FaultedHorizon horizon = MakeFaultedHorizon(options);
      const FaultDetection found = Detect(horizon);
      CHECK(AreChains(found.Lines));
      score.Add(ScoreFaults(horizon, found.Lines, 0, 2));
      // Each fault is a line or a few, with its own throw instead of that of a link.
      CHECK(found.Lines.Size() <= 8U);
      double sum = 0.0;
      for (std::size_t n = 0; n < found.Lines.NumberOfLinks(); ++n)
      {
        sum += std::abs(found.Lines[n].Throw);
      }
      // Picks that lie aslant to a fault make it wider than means are.
      CHECK(std::abs(sum / double(found.Lines.NumberOfLinks()) / largest - 1.0) < (width == 0 ? 0.35 : 0.2));
    }
    CHECK(score.FoundPercent(3) >= 95.0);
    CHECK(score.FalsePerThousand() < 0.2);
  }
}

void FoldsAreNoRamps()
{
  for (const double fold : { 0.5, 1.0, 2.0 })
  {
    for (const double noise : { 0.0, 0.3, 1.0 })
    {
      FaultGeneratorOptions options;
      options.NumberOfFaults = 0;
      options.Fold = fold;
      options.Noise = noise;
      options.Dip = 2.0;
      CHECK_EQUAL(Detect(MakeFaultedHorizon(options)).Lines.NumberOfLinks(), 0U);
    }
  }
}

/// Lines on both sides of a hole become one, unless their throws differ or they are not in line.
void JoinsThroughHoles()
{
  const auto step = [](int i, int j) { return i >= 20 && i < 44 && j >= 10 && j < 50 ? Missing : j < 30 ? 5.0 : 20.0; };
  FaultDetectionOptions options;
  const FaultDetection joined = DetectFaults(MakeHeights(64, 60, step), options);
  CHECK_EQUAL(joined.Lines.NumberOfLinks(), 64U);
  std::size_t known = 0;
  for (std::size_t n = 0; n < joined.Lines.NumberOfLinks(); ++n)
  {
    CHECK_EQUAL(joined.Lines[n].Place.Column.Y, 29);
    known += std::abs(joined.Lines[n].Throw - 15.0) < 1e-9 && std::abs(joined.Lines[n].Middle - 12.5) < 1e-9 ? 1 : 0;
  }
  CHECK_EQUAL(known, 64U);
  CHECK(AreChains(joined.Lines));
  options.JoinThroughHoles = false;
  CHECK_EQUAL(DetectFaults(MakeHeights(64, 60, step), options).Lines.NumberOfLinks(), 40U);
  options.JoinThroughHoles = true;
  // Down on one side, up on the other; and 14 rows aside.
  const auto scissors = [&](int i, int j) { return i < 32 ? step(i, j) : 25.0 - step(i, j); };
  CHECK_EQUAL(DetectFaults(MakeHeights(64, 60, scissors), options).Lines.NumberOfLinks(), 40U);
  const auto shifted = [&](int i, int j) {
    return std::isnan(step(i, j)) ? Missing : j < (i < 32 ? 23 : 37) ? 5.0 : 20.0;
  };
  CHECK_EQUAL(DetectFaults(MakeHeights(64, 60, shifted), options).Lines.NumberOfLinks(), 40U);
}

void ThreadsDoNotMatter()
{
  FaultGeneratorOptions options;
  options.AreTapered = true;
  options.AreCrossed = true;
  options.GapWidth = 2.0;
  const FaultedHorizon horizon = MakeFaultedHorizon(options);
  Detail::NumberOfThreads() = 1;
  const FaultDetection one = Detect(horizon);
  Detail::NumberOfThreads() = 5;
  const FaultDetection five = Detect(horizon);
  CHECK(one.Lines.NumberOfLinks() > 200U);
  CHECK_EQUAL(one.Noise, five.Noise);
  CHECK_EQUAL(one.Lines.Size(), five.Lines.Size());
  CHECK_EQUAL(ToText(one.Lines), ToText(five.Lines));
}

void RefusesBadInput()
{
  CHECK_THROWS_WITH(ColumnHeights({}, {}), "no points, expected a horizon");
  CHECK_THROWS_WITH(ColumnHeights({ { 1, 2 } }, { Missing }), "height nan in column (1, 2), expected a finite number");
  CHECK_THROWS_WITH(ColumnHeights({ { 1, 2 }, { 1, 2 } }, { 3.0, 4.0 }),
    "points 0 and 1 both in column (1, 2), expected at most one point of a horizon in a column");
  FaultDetectionOptions options;
  options.SmallestThrow = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(CheckOptions(options), "smallest throw inf, expected a finite number, at least 0 vertical indices");
  options = {};
  options.Noise = -1.0;
  CHECK_THROWS_WITH(CheckOptions(options), "noise -1, expected at least 0 vertical indices");
  options = {};
  options.SmallestExtent = -1;
  CHECK_THROWS_WITH(CheckOptions(options), "smallest extent -1, expected at least 0 columns");
  options = {};
  options.SmallestBranch = -2;
  CHECK_THROWS_WITH(CheckOptions(options), "smallest branch -2, expected at least 0 links");
  options = {};
  options.LargestGap = -3;
  CHECK_THROWS_WITH(CheckOptions(options), "largest gap -3, expected at least 0 columns");
  options = {};
  options.LargestRamp = 16;
  CHECK_THROWS_WITH(CheckOptions(options), "largest ramp 16, expected 0 to 10 columns");
}

void StopsOnRequest()
{
  const FaultedHorizon horizon = MakeFaultedHorizon({});
  const ColumnHeights heights(horizon.Columns, horizon.Height);
  bool stopped = false;
  try
  {
    DetectFaults(heights, {}, Monitor([](double part) { return part < 0.5; }));
  }
  catch (const Aborted&)
  {
    stopped = true;
  }
  CHECK(stopped);
}
}

int TestFaultDetection(int, char*[])
{
  FindsAStepExactly();
  NoiseIsMeasured();
  NoiseInStripesIsMeasured();
  FindsGeneratedFaults();
  FindsNothingWhereNothingIs();
  BridgesGaps();
  SmallHorizonsHaveNoFaults();
  PartsFarApartAreFound();
  FindsRamps();
  FoldsAreNoRamps();
  JoinsThroughHoles();
  ThreadsDoNotMatter();
  RefusesBadInput();
  StopsOnRequest();
  return Check::Result();
}
