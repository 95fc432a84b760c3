// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/GridPlacement.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/ShortSteps.h"
#include "Common/Survey/StrayPicks.h"
#include "Tools/Check.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// 20 x 20 picks of a dip, 25 m apart, in lines of a file from 3 on, of which line 103 is empty.
PickTable Dip()
{
  PickTable picks;
  picks.Names = { "Top" };
  picks.Lines = { { 0, 3 }, { 100, 104 } };
  for (int j = 0; j < 20; ++j)
  {
    for (int i = 0; i < 20; ++i)
    {
      picks.X.push_back(500000.0 + 25.0 * i);
      picks.Y.push_back(6000000.0 + 25.0 * j);
      picks.Z.push_back(1000.0 + i);
    }
  }
  return picks;
}

std::vector<std::string> DoubtsOf(const PickTable& picks, const PlacementOptions& options = PlacementOptions())
{
  return FindWarnings(PlacePicks(picks, options), options.Policy);
}

/// Another pick in the column of one, deeper by a difference.
void Double(PickTable& picks, std::size_t pick, double difference)
{
  picks.X.push_back(picks.X[pick]);
  picks.Y.push_back(picks.Y[pick]);
  picks.Z.push_back(picks.Z[pick] + difference);
}

bool IsOne(const std::vector<std::string>& warnings, const std::string& begins)
{
  return warnings.size() == 1 && warnings.front().compare(0, begins.size(), begins) == 0;
}

void TestNames()
{
  PickTable picks = Dip();
  CHECK_EQUAL(PicksText(picks, { 0 }), std::string("line 3"));
  CHECK_EQUAL(PicksText(picks, { 99, 100, 101 }), std::string("lines 102, 104, 105"));
  CHECK_EQUAL(PicksText(picks, { 1, 2, 3, 4, 5, 6 }), std::string("lines 4, 5, 6, 7, 8, ..."));
  picks.Lines.clear();
  CHECK_EQUAL(PicksText(picks, { 0 }), std::string("pick 1"));
}

void TestStrays()
{
  CHECK(DoubtsOf(Dip()).empty());
  PickTable picks = Dip();
  picks.X[150] += 9.0;
  CHECK_THROWS_WITH(DoubtsOf(picks), "1 of 400 picks off the lattice");
  CHECK_THROWS_WITH(DoubtsOf(picks), "the farthest, line 154, by ");
  PlacementOptions options;
  options.LeaveOutStrays = true;
  CHECK(IsOne(DoubtsOf(picks, options), "1 pick left out as strays: line 154"));
  picks = Dip();
  picks.X[399] = picks.Y[399] = 0.0;
  CHECK_THROWS_WITH(DoubtsOf(picks), "columns a pick; line 403, in column (0, 0), is the farthest from the others");
  CHECK(IsOne(DoubtsOf(picks, options), "1 pick left out as strays: line 403"));
  CHECK_EQUAL(PlacePicks(picks, options).Horizons.front().RealZ.size(), std::size_t(399));
}

/// Numbers count as in the file after some picks were left out, too.
void TestNumbersWithoutStrays()
{
  CHECK((OriginalNumbers({ 0, 1, 2, 3 }, { 0, 2, 3 }) == std::vector<std::size_t>{ 1, 4, 5, 6 }));
  PickTable picks = Dip();
  picks.X[10] += 1e6;
  for (std::size_t n = 281; n < 400; n += 2)
  {
    picks.X[n] += 9.0; // too many to leave out
  }
  PlacementOptions options;
  options.LeaveOutStrays = true;
  std::string message;
  try
  {
    PlacePicks(picks, options);
  }
  catch (const InputError& error)
  {
    message = error.what();
  }
  CHECK(message.find(" of 399 picks off the lattice") != std::string::npos);
  const std::size_t name = message.find("the farthest, line ");
  CHECK(name != std::string::npos);
  const int pick = std::stoi(message.substr(name + 19)) - 4; // Lines are 4 more from pick 100 on.
  CHECK(pick > 280 && pick % 2 == 1);
}

/// A wrong digit: on the lattice, or so near that this would turn a little to have it.
void TestFarPicks()
{
  PickTable picks = Dip();
  picks.X[250] += 7000.0;
  CHECK(IsOne(DoubtsOf(picks), "1 pick far from all others, line 254: StrayPicks leaves them out"));
  picks.X[250] += 8.0;
  CHECK_THROWS_WITH(DoubtsOf(picks), "picks off the lattice");
  CHECK_THROWS_WITH(DoubtsOf(picks), "line 254");
  picks = Dip();
  for (std::size_t n = 0; n < 100; ++n)
  {
    picks.X[n] += 25000.0; // another survey, or a part of this one
  }
  CHECK(DoubtsOf(picks).empty());
}

/// A wrong digit in the number of a line would make steps of 1 of those of 2.
void TestBetweenLines()
{
  PickTable picks = Dip();
  for (std::size_t n = 0; n < picks.Size(); ++n)
  {
    picks.Inline.push_back(100.0 + 2.0 * double(n / 20));
    picks.Crossline.push_back(500.0 + double(n % 20));
  }
  CHECK(DoubtsOf(picks).empty());
  PickTable wrong = picks;
  wrong.Inline[150] += 1.0;
  for (int round = 0; round < 2; ++round) // with places, and without
  {
    CHECK_THROWS_WITH(
      DoubtsOf(wrong), "1 of 400 picks between the lines of the others, line 154; expected line numbers");
    PlacementOptions options;
    options.LeaveOutStrays = true;
    CHECK(IsOne(DoubtsOf(wrong, options), "1 pick left out as strays: line 154"));
    CHECK_EQUAL(PlacePicks(wrong, options).Lattice.Lines->InlineStep, 2.0);
    wrong.X.clear();
    wrong.Y.clear();
  }
  // Two lines tell nothing, and neither do several of both kinds.
  PickTable two = picks;
  for (std::size_t n = 0; n < two.Size(); ++n)
  {
    two.Inline[n] = n < 396 ? 100.0 : 101.0;
  }
  CHECK(FindBetweenLines(two, LineNumbering{ 500.0, 1.0, 100.0, 1.0 }).empty());
  for (std::size_t n = 0; n < 20; ++n)
  {
    picks.Inline[n] += 1.0;
  }
  CHECK(FindBetweenLines(picks, LineNumbering{ 500.0, 1.0, 101.0, 1.0 }).empty());
}

void TestUsualNulls()
{
  PickTable picks = Dip();
  picks.Z[7] = picks.Z[8] = -999.0;
  CHECK(
    IsOne(DoubtsOf(picks), "2 of 400 points with z -999, far from all others, 1000 to 1019: add -999 to NullValues"));
  picks = Dip();
  picks.Z[7] = -999.25;
  CHECK(IsOne(DoubtsOf(picks), "1 of 400 points with z -999.25, far from all others, 1000 to 1019"));
  picks.Z[7] = picks.Z[8] = 999.0;
  CHECK(DoubtsOf(picks).empty()); // one more than the range of all others is not far
  picks.Z[7] = picks.Z[8] = 0.01;
  CHECK(IsOne(DoubtsOf(picks), "2 of 400 points with z 0.01, far from all others"));
  picks.Z[7] = 1000.0;
  CHECK(DoubtsOf(picks).empty()); // a spike
}

/// Level parts of a horizon are as far from each other as they like, but not as from a number for no value.
void TestLevelPlatforms()
{
  PickTable picks = Dip();
  for (std::size_t n = 0; n < picks.Size(); ++n)
  {
    picks.Z[n] = n < 100 ? 1200.0 : 1500.0;
  }
  CHECK(DoubtsOf(picks).empty());
  for (std::size_t n = 0; n < 100; ++n)
  {
    picks.Z[n] = -12345.0;
  }
  CHECK(IsOne(DoubtsOf(picks), "100 of 400 points with z -12345, far from all others, 1500 to 1500"));
  for (double& z : picks.Z)
  {
    z = 1000.0;
  }
  picks.Z[7] = -999.9;
  CHECK(DoubtsOf(picks).empty()); // The level horizon is not the null.
}

void TestSeveralNulls()
{
  PickTable picks = Dip();
  picks.Z[7] = -9999.0;
  picks.Z[8] = picks.Z[9] = -999.0;
  CHECK(IsOne(DoubtsOf(picks),
    "3 of 400 points with z -9999 or -999, far from all others, 1000 to 1019: add -9999 or -999 to NullValues"));
}

void TestNullsOfGrids()
{
  HorizonGrid grid;
  grid.Lattice.Columns = { 3, 2 };
  grid.Z = { 1500.0, 1501.0, 9999.0, 1502.0, 1503.0, 1504.0 };
  CHECK(IsOne(PlaceGrid(grid).Warnings, "1 of 6 points with z 9999, far from all others, 1500 to 1504"));
}

/// Exact repeats lose nothing; other duplicates do, and where these form lines a fault is likely.
void TestDuplicates()
{
  PickTable picks = Dip();
  for (std::size_t n = 0; n < 40; ++n)
  {
    Double(picks, n, 0.0);
  }
  SurveyHorizons placed = PlacePicks(picks, {});
  CHECK(FindWarnings(placed, DuplicatePolicy::StrongestAmplitude).empty());
  CHECK_EQUAL(placed.Conflicts.front().Repeats, 40);
  CHECK_EQUAL(placed.Horizons.front().DroppedDuplicates, 40);
  PickTable survey = Dip(); // another one overlaps
  for (std::size_t n = 0; n < 200; ++n)
  {
    Double(survey, n, n % 2 == 0 ? 0.5 : -0.5);
  }
  Double(survey, 399, 0.0);
  placed = PlacePicks(survey, {});
  CHECK_EQUAL(placed.Conflicts.front().Repeats, 1);
  CHECK_EQUAL(placed.Conflicts.front().Columns, 200);
  CHECK_EQUAL(placed.Horizons.front().DroppedDuplicates, 201);
  CHECK(IsOne(DoubtsOf(survey), "200 of 400 columns have several z, up to 0.5 apart: DuplicatePolicy chooses which"));
  PlacementOptions options;
  options.Policy = DuplicatePolicy::Mean;
  CHECK(DoubtsOf(survey, options).empty());
  for (const double slope : { 0.0, 0.4, 1.0, 3.0 }) // of a line of columns across the lattice
  {
    PickTable fault = Dip();
    for (int n = 0; n < 20; ++n)
    {
      const int across = int(slope > 1.0 ? 5 + n / slope : 2 + slope * n) % 20;
      Double(fault, std::size_t(slope > 1.0 ? 20 * n + across : 20 * across + n), 85.0);
    }
    CHECK(IsOne(DoubtsOf(fault), "20 of 400 columns have several z, up to 85 apart, "));
    CHECK(DoubtsOf(fault).front().find(" of them in lines, as along faults") != std::string::npos);
    CHECK_EQUAL(DoubtsOf(fault, options).size(), std::size_t(1));
    options.Policy = DuplicatePolicy::Sheets;
    CHECK(DoubtsOf(fault, options).empty());
    std::size_t points = 0;
    for (const LatticeHorizon& sheet : PlacePicks(fault, options).Horizons)
    {
      points += sheet.RealZ.size();
    }
    CHECK_EQUAL(points, std::size_t(420)); // both sides
    options.Policy = DuplicatePolicy::Mean;
  }
}

/// Of z and attributes, over what there is, in any order of picks.
void TestMean()
{
  PickTable picks = Dip();
  picks.Attributes = { { "Dip", std::vector<double>(400, 3.0) } };
  Double(picks, 7, 1.0);
  Double(picks, 7, 5.0);
  Double(picks, 8, 0.0);
  const double none = std::numeric_limits<double>::quiet_NaN();
  picks.Attributes[0].Values.insert(picks.Attributes[0].Values.end(), { 6.0, none, 3.0 });
  PlacementOptions options;
  options.Policy = DuplicatePolicy::Mean;
  const LatticeHorizon horizon = PlacePicks(picks, options).Horizons.front();
  CHECK_EQUAL(horizon.RealZ.size(), std::size_t(400));
  CHECK_EQUAL(horizon.RealZ[7], 1009.0);
  CHECK_EQUAL(horizon.RealZ[8], 1008.0);
  CHECK_EQUAL(horizon.Attributes[0].second[7], 4.5);
  CHECK_EQUAL(horizon.DroppedDuplicates, 3);
  std::swap(picks.Z[7], picks.Z[401]);
  CHECK_EQUAL(PlacePicks(picks, options).Horizons.front().RealZ[7], 1009.0);
}

/// Few places are on some lattice by chance.
void TestEvidence()
{
  PickTable wells;
  wells.Names = { "Top", "Base" };
  for (const int horizon : { 0, 1 })
  {
    for (const auto& [x, y] :
      { std::pair{ 0.0, 0.0 }, { 375.0, 0.0 }, { 25.0, 0.0 }, { 50.0, 125.0 }, { 250.0, 75.0 } })
    {
      wells.X.push_back(500000.0 + x);
      wells.Y.push_back(6000000.0 + y);
      wells.Z.push_back(1000.0 + x);
      wells.Horizon.push_back(horizon);
    }
  }
  CHECK_THROWS_WITH(PlacePicks(wells, {}), "Gridding makes a horizon of");
  PlacementOptions given;
  given.Source = LatticeSource::OriginAndSteps;
  given.Origin = { 500000.0, 6000000.0 };
  given.ColumnStep = { 25.0, 0.0 };
  given.RowStep = { 0.0, 25.0 };
  CHECK_EQUAL(PlacePicks(wells, given).Horizons.front().RealZ.size(), std::size_t(5));
  PickTable few;
  few.Names = { "Top" };
  few.X = { 0.0, 25.0, 0.0 };
  few.Y = { 0.0, 0.0, 40.0 };
  few.Z = { 1.0, 2.0, 3.0 };
  CHECK_THROWS_WITH(PlacePicks(few, {}), "picks at 3 positions, expected at least 6, or a full lattice");
  few.X.push_back(25.0);
  few.Y.push_back(40.0);
  few.Z.push_back(4.0);
  CHECK_EQUAL(PlacePicks(few, {}).Horizons.front().RealZ.size(), std::size_t(4));
  // Whole coordinates taken for lines are on a lattice of steps of 1; lines that have names may be few.
  PickTable lines;
  lines.Names = { "Top" };
  lines.Inline = { 100.0, 217.0, 310.0, 433.0 };
  lines.Crossline = { 1000.0, 1203.0, 1100.0, 1371.0 };
  lines.Z = few.Z;
  CHECK_EQUAL(PlacePicks(lines, {}).Horizons.front().RealZ.size(), std::size_t(4));
  lines.AreLinesGuessed = true;
  CHECK_THROWS_WITH(PlacePicks(lines, {}), "columns without names are X and Y");
}

void TestRounding()
{
  PickTable picks = Dip();
  CHECK_EQUAL(FindRounding(picks.X, picks.Y), 1.0);
  picks.X[17] += 0.1;
  CHECK_EQUAL(FindRounding(picks.X, picks.Y), 0.1);
  picks.Y[300] += 0.0001234;
  CHECK_EQUAL(FindRounding(picks.X, picks.Y), 0.0);
}
}

int TestPickWarnings(int, char*[])
{
  TestNames();
  TestStrays();
  TestNumbersWithoutStrays();
  TestFarPicks();
  TestBetweenLines();
  TestUsualNulls();
  TestLevelPlatforms();
  TestSeveralNulls();
  TestNullsOfGrids();
  TestDuplicates();
  TestMean();
  TestEvidence();
  TestRounding();
  return Check::Result();
}
