// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GriddingFixtures.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace GriddingFixtures;

namespace
{
/// Picks in wells: so many anywhere in squares of 3 m.
PickTable Wells(const std::vector<Eigen::Vector2d>& places, int count)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> off(0.0, 3.0);
  PickTable picks;
  picks.Names = { "Top" };
  for (const Eigen::Vector2d& place : places)
  {
    for (int n = 0; n < count; ++n)
    {
      picks.X.push_back(place.x() + off(random));
      picks.Y.push_back(place.y() + off(random));
      picks.Z.push_back(2000.0 + 3.0 * off(random));
    }
  }
  return picks;
}

/// Noise does not tilt the plate, and columns that nothing holds are left out.
void TestWells()
{
  const std::vector<Eigen::Vector2d> four = { { 0.0, 0.0 }, { 20000.0, 9000.0 }, { 20000.0, 0.0 }, { 0.0, 9000.0 } };
  for (const int wells : { 1, 2, 4 })
  {
    for (const int count : { 10, 1000 })
    {
      const PickTable picks = Wells({ four.begin(), four.begin() + wells }, count);
      // Far from a single well, whose columns are as small as its noise, this shows.
      for (const double radius : wells == 1 ? std::vector<double>{ 0.0 } : std::vector<double>{ 0.0, 1000.0 })
      {
        GriddingOptions options;
        options.Radius = radius;
        const SurveyHorizons gridded = GridPicks(picks, options);
        const std::pair<double, double> range = RangeOf(gridded.Horizons.front());
        CHECK(range.first > 1995.0 && range.second < 2014.0);
      }
    }
  }
  // Two picks on a diagonal, with columns in their hull that touch none of theirs.
  PickTable picks;
  picks.Names = { "Top" };
  picks.X = { 0.0, 500.0 };
  picks.Y = { 0.0, 500.0 };
  picks.Z = { 10.0, 20.0 };
  GriddingOptions options;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.ColumnStep = { 100.0, 0.0 };
  options.Placement.RowStep = { 0.0, 100.0 };
  for (const GriddingMethod method : { GriddingMethod::Plate, GriddingMethod::Nearest })
  {
    options.Method = method;
    const SurveyHorizons gridded = GridPicks(picks, options);
    const std::pair<double, double> range = RangeOf(gridded.Horizons.front());
    CHECK(range.first >= 10.0 - 1e-6 && range.second <= 20.0 + 1e-6);
    CHECK_EQUAL(gridded.Horizons.front().RealZ.size(), std::size_t(method == GriddingMethod::Plate ? 3 : 6));
  }
}

/// With any radius, also one below half a step.
void TestOwnColumns()
{
  const PickTable picks = Wells({ { 0.0, 0.0 }, { 17000.0, 9100.0 }, { 23000.0, 400.0 } }, 3);
  for (const double radius : { 1.0, 100.0, 3000.0, 20000.0 })
  {
    for (const GriddingMethod method : { GriddingMethod::Plate, GriddingMethod::Nearest })
    {
      GriddingOptions options;
      options.Radius = radius;
      options.Method = method;
      const LatticeHorizon gridded = GridPicks(picks, options).Horizons.front();
      const HeapArray<double>& counts = gridded.Attributes[1].second;
      CHECK_EQUAL(std::accumulate(counts.begin(), counts.end(), 0.0), 9.0);
    }
  }
}

void TestCrookedLine()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  PickTable picks;
  picks.Names = { "Top" };
  for (int n = 0; n < 800; ++n)
  {
    picks.X.push_back(25.0 * n);
    picks.Y.push_back(5.0 * noise(random));
    picks.Z.push_back(2000.0 + 0.01 * n + noise(random));
  }
  GriddingOptions options;
  options.Radius = 200.0;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.ColumnStep = { 25.0, 0.0 };
  options.Placement.RowStep = { 0.0, 25.0 };
  const std::pair<double, double> range = RangeOf(GridPicks(picks, options).Horizons.front());
  CHECK(range.first > 1997.0 && range.second < 2011.0); // of picks from 1999 to 2009
}

void TestStrays()
{
  PickTable picks = Scatter(2000, Plane);
  picks.Lines = { { 0, 3 } };
  const double step = GridPicks(picks, GriddingOptions()).Lattice.ColumnStep.x();
  for (const double far : { 0.0, 999.0, 1e9 })
  {
    PickTable stray = picks;
    stray.X[70] = stray.Y[70] = far;
    GriddingOptions options;
    CHECK_THROWS_WITH(GridPicks(stray, options),
      "1 of 2000 picks far from all others, line 73; expected StrayPicks LeaveOut, or LatticeSource");
    options.Placement.LeaveOutStrays = true;
    const SurveyHorizons gridded = GridPicks(stray, options);
    CHECK_EQUAL(gridded.Lattice.ColumnStep.x(), step);
    CHECK_EQUAL(gridded.Warnings.front(), std::string("1 pick left out as strays: line 73"));
    CHECK_THROWS_WITH(GridPicks(stray, Turned(GriddingMethod::Plate)), "far from all others, line 73");
  }
  // Where the lattice is given, only a warning.
  picks.X[70] += 9000.0;
  const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Nearest));
  CHECK_EQUAL(gridded.Warnings.front(), std::string("1 pick far from all others, line 73: StrayPicks leaves them out"));
  // Another area is none, and of ten picks one that is far enough.
  picks = Scatter(2000, Plane);
  std::for_each(picks.X.begin(), picks.X.begin() + 400, [](double& x) { x += 20000.0; });
  CHECK(GridPicks(picks, GriddingOptions()).Warnings.empty());
  picks = Scatter(10, Plane);
  picks.X[4] = picks.Y[4] = 0.0;
  CHECK_THROWS_WITH(GridPicks(picks, GriddingOptions()), "1 of 10 picks far from all others, pick 5");
}

/// Numbers for no value are found among picks: the plate would smear them.
void TestNulls()
{
  for (const GriddingMethod method : { GriddingMethod::Plate, GriddingMethod::Nearest })
  {
    for (const auto& [null, said] :
      std::map<double, std::string>{ { -999.25, "-999.25," }, { 0.0, "0," }, { -99999.0, "-99999," } })
    {
      PickTable picks = Scatter(500, [](double x, double) { return 1500.0 + 0.01 * x; });
      picks.Z[17] = null;
      const std::vector<std::string> warnings =
        FindWarnings(GridPicks(picks, Turned(method)), DuplicatePolicy::StrongestAmplitude);
      CHECK_EQUAL(warnings.size(), std::size_t(1));
      CHECK(!warnings.empty() && warnings.front().find("1 of 500 points with z " + said) == 0);
    }
  }
}

double HeightAt(const SurveyHorizons& gridded, double x, double y)
{
  const LatticeHorizon& horizon = gridded.Horizons.front();
  for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
  {
    if ((PlaceOf(gridded.Lattice, horizon.Column[n]) - Eigen::Vector2d(x, y)).norm() < 1e-9)
    {
      return horizon.RealZ[n];
    }
  }
  return std::nan("");
}

/// Of picks at one place the policy chooses, and the order of all of them does not matter.
void TestDuplicates()
{
  GriddingOptions options;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.ColumnStep = { 50.0, 0.0 };
  options.Placement.RowStep = { 0.0, 50.0 };
  for (const GriddingMethod method : { GriddingMethod::Plate, GriddingMethod::Nearest })
  {
    for (const DuplicatePolicy policy :
      { DuplicatePolicy::Topmost, DuplicatePolicy::Lowest, DuplicatePolicy::StrongestAmplitude })
    {
      for (const bool isTurned : { false, true })
      {
        PickTable picks;
        picks.Names = { "Top" };
        picks.X = { 0.0, 0.0, 100.0, 0.0, 100.0 };
        picks.Y = { 0.0, 0.0, 0.0, 100.0, 100.0 };
        picks.Z = { 1400.0, 1600.0, 1500.0, 1510.0, 1520.0 };
        picks.Attributes = { { "Amplitude", { 1.0, -2.0, 1.0, 1.0, 1.0 } } };
        if (isTurned)
        {
          for (std::vector<double>* const values : { &picks.X, &picks.Y, &picks.Z, &picks.Attributes[0].Values })
          {
            std::reverse(values->begin(), values->end());
          }
        }
        options.Method = method;
        options.Placement.Policy = policy;
        options.Smoothing = 0.0;
        const SurveyHorizons gridded = GridPicks(picks, options);
        CHECK_EQUAL(gridded.Horizons.front().DroppedDuplicates, std::int64_t(1));
        const double z = policy == DuplicatePolicy::Topmost ? 1400.0 : 1600.0;
        CHECK(std::abs(HeightAt(gridded, 0.0, 0.0) - z) < 0.01);
        if (method == GriddingMethod::Nearest)
        {
          CHECK_EQUAL(HeightAt(gridded, 50.0, 50.0), z); // as far from all: the least x, then y
        }
      }
    }
  }
}

void TestOrder()
{
  const PickTable picks = Scatter(400, [](double x, double y) { return std::sin(x / 300.0) * y; });
  PickTable turned = picks;
  for (std::vector<double>* const values : { &turned.X, &turned.Y, &turned.Z })
  {
    std::reverse(values->begin(), values->end());
  }
  for (const GriddingMethod method : { GriddingMethod::Plate, GriddingMethod::Nearest })
  {
    const SurveyHorizons one = GridPicks(picks, Turned(method));
    const SurveyHorizons other = GridPicks(turned, Turned(method));
    CHECK(std::equal(one.Horizons[0].RealZ.begin(), one.Horizons[0].RealZ.end(), other.Horizons[0].RealZ.begin(),
      other.Horizons[0].RealZ.end()));
  }
}

/// Unequal steps, and those that are not perpendicular, find the same surface.
void TestSteps()
{
  const auto height = [](double x, double y) { return 2000.0 + 40.0 * std::sin(x / 350.0) * std::cos(y / 420.0); };
  const PickTable picks = Scatter(120, height);
  std::vector<double> off;
  for (const auto& [column, row] : std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>{
         { { 25.0, 0.0 }, { 0.0, 25.0 } }, { { 12.5, 0.0 }, { 0.0, 50.0 } }, { { 100.0, 0.0 }, { 0.0, 6.25 } },
         { { 6.25, 0.0 }, { 0.0, 100.0 } }, { { 25.0, 0.0 }, { 50.0, 25.0 } } })
  {
    GriddingOptions options = Turned(GriddingMethod::Plate);
    options.Placement.ColumnStep = column;
    options.Placement.RowStep = row;
    const SurveyHorizons gridded = GridPicks(picks, options);
    double sum = 0.0;
    for (std::size_t n = 0; n < gridded.Horizons[0].RealZ.size(); ++n)
    {
      const Eigen::Vector2d place = PlaceOf(gridded.Lattice, gridded.Horizons[0].Column[n]);
      sum += std::pow(gridded.Horizons[0].RealZ[n] - height(place.x() - OriginX, place.y() - OriginY), 2);
    }
    off.push_back(std::sqrt(sum / double(gridded.Horizons[0].RealZ.size())));
  }
  CHECK(*std::max_element(off.begin(), off.end()) < 2.0 * off.front());
}

/// Every column of clusters, by looking at all picks; and so many picks that looking at all would take minutes.
void TestClusters()
{
  const PickTable picks = Wells({ { 0.0, 0.0 }, { 900.0, 400.0 }, { 30.0, 800.0 } }, 50);
  GriddingOptions options = Turned(GriddingMethod::Nearest);
  const SurveyHorizons gridded = GridPicks(picks, options);
  for (std::size_t n = 0; n < gridded.Horizons[0].RealZ.size(); ++n)
  {
    const Eigen::Vector2d place = PlaceOf(gridded.Lattice, gridded.Horizons[0].Column[n]);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t pick = 0; pick < picks.Size(); ++pick)
    {
      least = std::min(least, (Eigen::Vector2d(picks.X[pick], picks.Y[pick]) - place).norm());
    }
    CHECK(std::abs(AttributeOf(gridded.Horizons[0], "PickDistance")[n] - least) < 1e-6);
  }
  const PickTable many = Wells({ { 0.0, 0.0 }, { 50000.0, 0.0 }, { 50000.0, 50000.0 }, { 0.0, 50000.0 } }, 50000);
  CHECK(GridPicks(many, { GriddingMethod::Nearest, 0.0, 0.01, {} }).Horizons[0].RealZ.size() > 100000);
}
}

int TestGriddedPicks(int, char*[])
{
  TestWells();
  TestOwnColumns();
  TestCrookedLine();
  TestStrays();
  TestNulls();
  TestDuplicates();
  TestOrder();
  TestSteps();
  TestClusters();
  return Check::Result();
}
