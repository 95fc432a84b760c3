// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/PickPlacement.h"
#include "Tools/Check.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

using namespace SeismicHorizons;

namespace
{
const double Null = std::nan("");

/// Inlines 100, 104, 108 and crosslines 20 to 28 in steps of 2, by ascending inline and then crossline; z tells both.
PickTable LineTable()
{
  PickTable picks;
  picks.Names = { "Top" };
  for (const double inlineNumber : { 100.0, 104.0, 108.0 })
  {
    for (const double crossline : { 20.0, 22.0, 24.0, 26.0, 28.0 })
    {
      picks.Inline.push_back(inlineNumber);
      picks.Crossline.push_back(crossline);
      picks.Z.push_back(1000.0 * inlineNumber + crossline);
    }
  }
  return picks;
}

/// The same with places: crosslines run to the north, inlines to the east, so that the lattice is left-handed.
PickTable TurnedTable()
{
  PickTable picks = LineTable();
  for (std::size_t n = 0; n < picks.Size(); ++n)
  {
    picks.X.push_back(500000.0 + 12.5 * picks.Inline[n]);
    picks.Y.push_back(6000000.0 + 25.0 * picks.Crossline[n]);
  }
  return picks;
}

bool IsNear(const Eigen::Vector2d& a, double x, double y)
{
  return (a - Eigen::Vector2d(x, y)).norm() < 1e-6;
}

void TestLinesAlone()
{
  const SurveyHorizons placed = PlacePicks(LineTable(), {});
  CHECK_EQUAL(placed.Lattice.Columns[0], 5);
  CHECK_EQUAL(placed.Lattice.Columns[1], 3);
  CHECK(IsNear(placed.Lattice.Origin, 20.0, 100.0));
  CHECK(IsNear(placed.Lattice.ColumnStep, 2.0, 0.0));
  CHECK(IsNear(placed.Lattice.RowStep, 0.0, 4.0));
  CHECK_EQUAL(placed.Lattice.Lines->FirstInline, 100.0);
  CHECK_EQUAL(placed.Lattice.Lines->InlineStep, 4.0);
  CHECK_EQUAL(placed.Horizons.size(), std::size_t(1));
  const LatticeHorizon& horizon = placed.Horizons.front();
  CHECK_EQUAL(horizon.Column[6].X, 1);
  CHECK_EQUAL(horizon.Column[6].Y, 1);
  CHECK_EQUAL(horizon.RealZ[6], 104022.0);
}

void TestLinesAndPlaces()
{
  const SurveyHorizons placed = PlacePicks(TurnedTable(), {});
  CHECK(IsNear(placed.Lattice.Origin, 501250.0, 6000500.0));
  CHECK(IsNear(placed.Lattice.ColumnStep, 0.0, 50.0));
  CHECK(IsNear(placed.Lattice.RowStep, 50.0, 0.0));
  CHECK(placed.LargestDistance < 1e-9);
}

void TestPlacesAlone()
{
  PickTable picks = TurnedTable();
  picks.Inline.clear();
  picks.Crossline.clear();
  const SurveyHorizons placed = PlacePicks(picks, {});
  CHECK(!placed.Lattice.Lines);
  CHECK_EQUAL(placed.Lattice.Columns[0], 3);
  CHECK_EQUAL(placed.Lattice.Columns[1], 5);
  CHECK(IsNear(placed.Lattice.Origin, 501250.0, 6000500.0));
  CHECK(IsNear(placed.Lattice.ColumnStep, 50.0, 0.0));
  const LatticeHorizon& horizon = placed.Horizons.front();
  CHECK_EQUAL(horizon.RealZ[1], 104020.0); // by ascending j, then i
  CHECK_EQUAL(horizon.Column[1].X, 1);
}

/// Picks of one inline do not tell the step to the next: it is as long as that along the line, and to its left.
void TestOneLine()
{
  PickTable picks;
  picks.Names = { "Line" };
  picks.Inline = { 7.0, 7.0, 7.0 };
  picks.Crossline = { 1.0, 2.0, 4.0 };
  picks.X = { 103.0, 106.0, 112.0 };
  picks.Y = { 204.0, 208.0, 216.0 };
  picks.Z = { 1.0, 2.0, 3.0 };
  const SurveyLattice lattice = PlacePicks(picks, {}).Lattice;
  CHECK_EQUAL(lattice.Columns[0], 4);
  CHECK_EQUAL(lattice.Columns[1], 1);
  CHECK(IsNear(lattice.Origin, 103.0, 204.0));
  CHECK(IsNear(lattice.ColumnStep, 3.0, 4.0));
  CHECK(IsNear(lattice.RowStep, -4.0, 3.0));
  std::swap(picks.Inline, picks.Crossline);
  CHECK(IsNear(PlacePicks(picks, {}).Lattice.RowStep, 3.0, 4.0));
  CHECK(IsNear(PlacePicks(picks, {}).Lattice.ColumnStep, 4.0, -3.0));
}

/// Steps of three decimals, and what is not one.
void TestFractions()
{
  PickTable picks = LineTable();
  picks.Crossline[3] = 25.5;
  CHECK(IsNear(PlacePicks(picks, {}).Lattice.ColumnStep, 0.5, 0.0));
  picks.Crossline[3] = 1.0 / 3.0;
  CHECK_THROWS_WITH(
    PlacePicks(picks, {}), "crossline 0.33333333333333331, expected a line number with at most three decimals");
  picks.Crossline[3] = 1e13;
  CHECK_THROWS_WITH(PlacePicks(picks, {}), "crossline 10000000000000, expected");
}

void TestCorners()
{
  PlacementOptions options;
  options.Source = LatticeSource::CornerPoints;
  options.Corners = { CornerPoint{ 100.0, 20.0, 0.0, 0.0 }, { 100.0, 40.0, 100.0, 0.0 }, { 300.0, 20.0, 0.0, 400.0 } };
  const SurveyHorizons placed = PlacePicks(LineTable(), options);
  CHECK(IsNear(placed.Lattice.Origin, 0.0, 0.0));
  CHECK(IsNear(placed.Lattice.ColumnStep, 10.0, 0.0));
  CHECK(IsNear(placed.Lattice.RowStep, 0.0, 8.0));
  options.Corners[2].X = Null;
  CHECK_THROWS_WITH(PlacePicks(LineTable(), options), "corner point (300, 20, nan, 400), expected finite numbers");
  options.Corners[2] = { 100.0, 60.0, 200.0, 0.0 };
  CHECK_THROWS_WITH(PlacePicks(LineTable(), options), "three corner points whose line numbers are on one line");
  PickTable places = TurnedTable();
  places.Inline.clear();
  places.Crossline.clear();
  CHECK_THROWS_WITH(PlacePicks(places, options), "corner points for picks without line numbers, expected");
}

void TestGivenSteps()
{
  PlacementOptions options;
  options.Source = LatticeSource::OriginAndSteps;
  options.Origin = { 7.0, 8.0 };
  options.ColumnStep = { 3.0, 4.0 };
  options.RowStep = { -4.0, 3.0 };
  const SurveyLattice lattice = PlacePicks(LineTable(), options).Lattice;
  CHECK(IsNear(lattice.Origin, 7.0, 8.0));
  CHECK(IsNear(lattice.ColumnStep, 3.0, 4.0));
  options.RowStep = { 6.0, 8.0 };
  CHECK_THROWS_WITH(PlacePicks(LineTable(), options), "ColumnStep (3, 4) and RowStep (6, 8), expected finite vectors");
  options.RowStep = { -4.0, 3.0 };
  // Places of the picks have to be on that lattice.
  CHECK_THROWS_WITH(
    PlacePicks(TurnedTable(), options), "15 of 15 picks off the lattice with the steps (3, 4) and (-4, 3)");
}

void TestDuplicatesAndNulls()
{
  PickTable picks;
  picks.Names = { "A", "B" };
  picks.Horizon = { 0, 0, 0, 1, 1, 1, 0 };
  picks.Inline = { 1, 1, 2, 1, 1, 1, 1 };
  picks.Crossline = { 2, 1, 1, 2, 2, 1, 2 };
  picks.Z = { 10.0, 11.0, 12.0, Null, 20.0, 21.0, 13.0 };
  picks.Attributes = { { "amplitude", { -5.0, 1.0, 1.0, 1.0, 1.0, 1.0, 4.0 } } };
  PlacementOptions options;
  const SurveyHorizons strongest = PlacePicks(picks, options);
  const LatticeHorizon& a = strongest.Horizons[0];
  CHECK(a.RealZ == std::vector<double>({ 11.0, 10.0, 12.0 }));
  CHECK(a.Column == std::vector<PlanePoint>({ { 0, 0 }, { 1, 0 }, { 0, 1 } }));
  CHECK(a.Attributes[0].second == std::vector<double>({ 1.0, -5.0, 1.0 }));
  CHECK_EQUAL(a.DroppedDuplicates, 1);
  CHECK_EQUAL(a.DroppedNulls, 0);
  const LatticeHorizon& b = strongest.Horizons[1];
  CHECK(b.RealZ == std::vector<double>({ 21.0, 20.0 }));
  CHECK_EQUAL(b.DroppedDuplicates, 0);
  CHECK_EQUAL(b.DroppedNulls, 1);
  options.Policy = DuplicatePolicy::Lowest;
  CHECK_EQUAL(PlacePicks(picks, options).Horizons[0].RealZ[1], 13.0);
  options.Direction = VerticalDirection::Up;
  CHECK_EQUAL(PlacePicks(picks, options).Horizons[0].RealZ[1], 10.0);
  options.Policy = DuplicatePolicy::Topmost;
  CHECK_EQUAL(PlacePicks(picks, options).Horizons[0].RealZ[1], 13.0);
}

/// A row of columns at which the left block reaches over the right one, picked in any order, with a pick twice.
void TestSheets()
{
  PickTable picks;
  picks.Names = { "One", "Faulted", "Empty" };
  for (const double i : { 5.0, 0.0, 3.0, 1.0, 2.0, 4.0, 6.0 })
  {
    for (const double z : { 30.5, 10.25, 10.25 })
    {
      if (z > 20.0 ? i >= 2.0 : i <= 3.0)
      {
        picks.Crossline.push_back(i);
        picks.Inline.push_back(1.0);
        picks.Z.push_back(z);
        picks.Horizon.push_back(1);
      }
    }
  }
  picks.Crossline.insert(picks.Crossline.end(), { 2.0, 3.0 });
  picks.Inline.insert(picks.Inline.end(), { 1.0, 1.0 });
  picks.Z.insert(picks.Z.end(), { 7.0, Null });
  picks.Horizon.insert(picks.Horizon.end(), { 0, 2 });
  picks.Attributes = { { "Amplitude", picks.Z } };
  PlacementOptions options;
  options.Policy = DuplicatePolicy::Sheets;
  const std::vector<LatticeHorizon> sheets = PlacePicks(picks, options).Horizons;
  CHECK_EQUAL(sheets.size(), std::size_t(4));
  const std::array<int, 4> ids = { sheets[0].SurfaceId, sheets[1].SurfaceId, sheets[2].SurfaceId, sheets[3].SurfaceId };
  CHECK(ids == (std::array<int, 4>{ 1, 2, 2, 3 }));
  const auto columns = [](const LatticeHorizon& sheet)
  {
    std::vector<int> i;
    for (const PlanePoint& column : sheet.Column)
    {
      i.push_back(column.X);
    }
    return i;
  };
  CHECK(columns(sheets[1]) == std::vector<int>({ 2, 3, 4, 5, 6 }));
  CHECK(sheets[1].RealZ == std::vector<double>(5, 30.5));
  CHECK(sheets[1].Attributes[0].second == sheets[1].RealZ);
  CHECK(columns(sheets[2]) == std::vector<int>({ 0, 1, 2, 3 }));
  CHECK(sheets[2].RealZ == std::vector<double>(4, 10.25));
  CHECK_EQUAL(sheets[1].DroppedDuplicates, 4); // those that are there twice
  CHECK_EQUAL(sheets[2].DroppedDuplicates, 0);
  CHECK_EQUAL(sheets[3].DroppedNulls, 1);
  CHECK(sheets[3].RealZ.empty());
}

/// A dataset takes memory however small it is.
void TestTooManySheets()
{
  PickTable picks;
  picks.Names.resize(600, "Pile");
  for (int horizon = 0; horizon < 600; ++horizon)
  {
    for (int level = 0; level < 64; ++level)
    {
      picks.Horizon.push_back(horizon);
      picks.Crossline.push_back(1.0);
      picks.Inline.push_back(1.0);
      picks.Z.push_back(level);
    }
  }
  PlacementOptions options;
  options.Policy = DuplicatePolicy::Sheets;
  CHECK_THROWS_WITH(PlacePicks(picks, options), "38400 picks of 32832 sheets, expected at most 32768");
}

void TestOffLattice()
{
  PickTable picks = TurnedTable();
  picks.X[7] += 10.0;
  CHECK_THROWS_WITH(PlacePicks(picks, {}), "1 of 15 picks off the lattice with the steps (");
  PlacementOptions options;
  options.Tolerance = 0.3;
  const SurveyHorizons moved = PlacePicks(picks, options);
  CHECK(moved.LargestDistance > 0.15);
  CHECK_EQUAL(moved.Warnings.size(), std::size_t(1));
  CHECK_EQUAL(moved.Warnings.front(),
    "picks are moved by up to 9.333, in the unit of x and y, onto the lattice with the steps (0, 50) and (50, 0): "
    "LatticeSource OriginAndSteps sets another lattice, Gridding needs none");
  options.Tolerance = 0.5;
  CHECK_THROWS_WITH(PlacePicks(picks, options), "LatticeTolerance 0.5, expected more than 0 and less than 0.5 columns");
  options.Tolerance = Null;
  CHECK_THROWS_WITH(PlacePicks(picks, options), "LatticeTolerance nan, expected");
}

void TestRefusals()
{
  PickTable none;
  none.Names = { "none" };
  CHECK_THROWS_WITH(PlacePicks(none, {}), "0 picks, expected at least 1 and less than 2^31");
  PickTable diagonal = TurnedTable();
  diagonal.Inline = diagonal.Crossline;
  CHECK_THROWS_WITH(PlacePicks(diagonal, {}), "picks on one line, expected some that span a lattice");
  PickTable samePlace = TurnedTable();
  samePlace.X.assign(samePlace.Size(), 1.0);
  CHECK_THROWS_WITH(PlacePicks(samePlace, {}), "positions of picks on one line, expected some that span a lattice");
  PickTable farAway = LineTable();
  farAway.Inline[3] = 4e9;
  CHECK_THROWS_WITH(
    PlacePicks(farAway, {}), "lattice of 5 x 999999976 columns with the steps (2, 0) and (0, 4), expected");
  PickTable many = LineTable();
  many.Names.resize(32769);
  CHECK_THROWS_WITH(PlacePicks(many, {}), " picks of 32769 horizons, expected at most 32768");
  PickTable stray = LineTable();
  stray.Inline.push_back(4000100.0);
  stray.Crossline.push_back(40020.0);
  stray.Z.push_back(0.0);
  CHECK_THROWS_WITH(PlacePicks(stray, {}),
    "lattice of 20001 x 1000001 columns for 16 picks, expected at most 1000 columns "
    "a pick; pick 16, in column (20000, 1000000), is the farthest from the others");
}
}

int TestPickPlacement(int, char*[])
{
  TestLinesAlone();
  TestLinesAndPlaces();
  TestPlacesAlone();
  TestOneLine();
  TestFractions();
  TestCorners();
  TestGivenSteps();
  TestDuplicatesAndNulls();
  TestSheets();
  TestTooManySheets();
  TestOffLattice();
  TestRefusals();
  return Check::Result();
}
