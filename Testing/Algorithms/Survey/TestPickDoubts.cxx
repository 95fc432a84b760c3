// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/PickDoubts.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/Survey/ShortSteps.h"
#include "Common/Survey/StrayPicks.h"
#include "Tools/Check.h"

#include <string>
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
  return FindDoubts(PlacePicks(picks, options));
}

bool IsOne(const std::vector<std::string>& doubts, const std::string& begins)
{
  return doubts.size() == 1 && doubts.front().compare(0, begins.size(), begins) == 0;
}

void TestNames()
{
  PickTable picks = Dip();
  CHECK_EQUAL(SayPicks(picks, { 0 }), std::string("line 3"));
  CHECK_EQUAL(SayPicks(picks, { 99, 100, 101 }), std::string("lines 102, 104, 105"));
  CHECK_EQUAL(SayPicks(picks, { 1, 2, 3, 4, 5, 6 }), std::string("lines 4, 5, 6, 7, 8, ..."));
  picks.Lines.clear();
  CHECK_EQUAL(SayPicks(picks, { 0 }), std::string("pick 1"));
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
  CHECK(IsOne(DoubtsOf(picks, options), "1 stray picks left out: line 154"));
  picks = Dip();
  picks.X[399] = picks.Y[399] = 0.0;
  CHECK_THROWS_WITH(DoubtsOf(picks), "columns a pick; line 403, in column (0, 0), is the farthest from the others");
  CHECK(IsOne(DoubtsOf(picks, options), "1 stray picks left out: line 403"));
  CHECK_EQUAL(PlacePicks(picks, options).Horizons.front().RealZ.size(), std::size_t(399));
}

/// A wrong digit: on the lattice, or so near that this would turn a little to have it.
void TestFarPicks()
{
  PickTable picks = Dip();
  picks.X[250] += 7000.0;
  CHECK(IsOne(DoubtsOf(picks), "1 picks far from all others, line 254: StrayPicks leaves them out"));
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
    CHECK(IsOne(DoubtsOf(wrong, options), "1 stray picks left out: line 154"));
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
    IsOne(DoubtsOf(picks), "2 of 400 picks with z -999, far from all others, 1000 to 1019: add -999 to NullValues"));
  picks = Dip();
  picks.Z[7] = -999.25;
  CHECK(IsOne(DoubtsOf(picks), "1 of 400 picks with z -999.25, far from all others, 1000 to 1019"));
  picks.Z[7] = picks.Z[8] = 999.0;
  CHECK(DoubtsOf(picks).empty()); // one more than the range of all others is not far
  picks.Z[7] = picks.Z[8] = 0.01;
  CHECK(IsOne(DoubtsOf(picks), "2 of 400 picks with z 0.01, far from all others"));
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
  CHECK(IsOne(DoubtsOf(picks), "100 of 400 picks with z -12345, far from all others, 1500 to 1500"));
}

void TestDuplicates()
{
  PickTable picks = Dip();
  for (int n = 0; n < 4; ++n)
  {
    picks.X[std::size_t(n)] = picks.X[10];
  }
  CHECK(DoubtsOf(picks).empty()); // a hundredth
  picks.X[4] = picks.X[10];
  CHECK(IsOne(DoubtsOf(picks), "5 of 400 picks dropped, as their column has another one"));
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

int TestPickDoubts(int, char*[])
{
  TestNames();
  TestStrays();
  TestFarPicks();
  TestBetweenLines();
  TestUsualNulls();
  TestLevelPlatforms();
  TestDuplicates();
  TestRounding();
  return Check::Result();
}
