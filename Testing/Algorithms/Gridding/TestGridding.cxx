// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Parallel.h"
#include "Common/Survey/PickDoubts.h"
#include "Gridding/Gridding.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr double OriginX = 431000.0;
constexpr double OriginY = 6348000.0;

/// Picks anywhere in a square of 2 km, with a z by their place.
template <typename Height>
PickTable Scatter(int count, Height&& height)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 2000.0);
  PickTable picks;
  picks.Names = { "Top" };
  for (int n = 0; n < count; ++n)
  {
    picks.X.push_back(OriginX + place(random));
    picks.Y.push_back(OriginY + place(random));
    picks.Z.push_back(height(picks.X.back() - OriginX, picks.Y.back() - OriginY));
  }
  return picks;
}

double Plane(double x, double y)
{
  return 1500.0 + 0.3 * x - 0.11 * y;
}

GriddingOptions Turned(GriddingMethod method, double radius = 0.0)
{
  GriddingOptions options;
  options.Method = method;
  options.Radius = radius;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.Origin = { OriginX + 3.0, OriginY - 7.0 };
  options.Placement.ColumnStep = { 40.0, 17.0 };
  options.Placement.RowStep = { -12.0, 25.0 };
  return options;
}

Eigen::Vector2d PlaceOf(const SurveyLattice& lattice, const PlanePoint& column)
{
  return lattice.Origin + lattice.Steps() * Eigen::Vector2d(column.X, column.Y);
}

const HeapArray<double>& AttributeOf(const LatticeHorizon& horizon, const std::string& name)
{
  return std::find_if(horizon.Attributes.begin(), horizon.Attributes.end(),
    [&](const auto& attribute) { return attribute.first == name; })
    ->second;
}

void TestPlane()
{
  const PickTable picks = Scatter(300, Plane);
  for (const GriddingOptions& options :
    { GriddingOptions(), Turned(GriddingMethod::Plate), Turned(GriddingMethod::Plate, 150.0) })
  {
    const SurveyHorizons gridded = GridPicks(picks, options);
    const LatticeHorizon& horizon = gridded.Horizons.front();
    CHECK(horizon.RealZ.size() > 200);
    double largest = 0.0;
    for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
    {
      const Eigen::Vector2d place = PlaceOf(gridded.Lattice, horizon.Column[n]);
      largest = std::max(largest, std::abs(horizon.RealZ[n] - Plane(place.x() - OriginX, place.y() - OriginY)));
    }
    CHECK(largest < 1e-6);
  }
}

/// Every column is looked at, and every pick.
void TestNearest()
{
  const PickTable picks = Scatter(200, [](double x, double y) { return std::sin(x) + y; });
  constexpr double radius = 120.0;
  const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Nearest, radius));
  const LatticeHorizon& horizon = gridded.Horizons.front();
  std::map<std::pair<int, int>, std::size_t> found;
  for (std::size_t n = 0; n < horizon.Column.size(); ++n)
  {
    found[{ horizon.Column[n].X, horizon.Column[n].Y }] = n;
  }
  double pickCount = 0.0;
  for (int j = 0; j < gridded.Lattice.Columns[1]; ++j)
  {
    for (int i = 0; i < gridded.Lattice.Columns[0]; ++i)
    {
      const Eigen::Vector2d place = PlaceOf(gridded.Lattice, { i, j });
      double least = std::numeric_limits<double>::infinity();
      double z = 0.0;
      for (std::size_t pick = 0; pick < picks.Size(); ++pick)
      {
        const double distance = (Eigen::Vector2d(picks.X[pick], picks.Y[pick]) - place).norm();
        z = distance < least ? picks.Z[pick] : z;
        least = std::min(least, distance);
      }
      const auto column = found.find({ i, j });
      CHECK_EQUAL(column != found.end(), least <= radius);
      if (column != found.end())
      {
        CHECK_EQUAL(horizon.RealZ[column->second], z);
        CHECK(std::abs(AttributeOf(horizon, "PickDistance")[column->second] - least) < 1e-6);
        const double count = AttributeOf(horizon, "PickCount")[column->second];
        CHECK_EQUAL(AttributeOf(horizon, "Filled")[column->second], count == 0.0 ? 1.0 : 0.0);
        pickCount += count;
      }
    }
  }
  CHECK_EQUAL(pickCount, 200.0);
}

/// Near to picks, and no further than these from a smooth surface.
void TestSmoothSurface()
{
  const auto height = [](double x, double y) { return 1500.0 + 40.0 * std::sin(x / 400.0) * std::cos(y / 500.0); };
  const PickTable picks = Scatter(2000, height);
  const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Plate));
  const LatticeHorizon& horizon = gridded.Horizons.front();
  double largest = 0.0;
  for (std::size_t n = 0; n < horizon.RealZ.size(); ++n)
  {
    const Eigen::Vector2d place = PlaceOf(gridded.Lattice, horizon.Column[n]);
    const double off = std::abs(horizon.RealZ[n] - height(place.x() - OriginX, place.y() - OriginY));
    largest = std::max(largest, off);
  }
  CHECK(largest < 1.0); // of 80 from least to greatest
}

void TestFewPicks()
{
  PickTable picks = Scatter(1, Plane);
  SurveyHorizons gridded = GridPicks(picks, GriddingOptions());
  CHECK_EQUAL(gridded.Horizons.front().RealZ.size(), std::size_t(1));
  CHECK(std::abs(gridded.Horizons.front().RealZ[0] - picks.Z[0]) < 1e-6);
  // Four picks on a line along x, of which z rises: across it the surface is level.
  picks = PickTable();
  picks.Names = { "Top" };
  for (int n = 0; n < 4; ++n)
  {
    picks.X.push_back(100.0 * n);
    picks.Y.push_back(0.0);
    picks.Z.push_back(10.0 * n);
  }
  GriddingOptions options;
  options.Radius = 60.0;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.ColumnStep = { 20.0, 0.0 };
  options.Placement.RowStep = { 0.0, 20.0 };
  gridded = GridPicks(picks, options);
  CHECK(gridded.Horizons.front().RealZ.size() > 80);
  for (std::size_t n = 0; n < gridded.Horizons.front().RealZ.size(); ++n)
  {
    const Eigen::Vector2d place = PlaceOf(gridded.Lattice, gridded.Horizons.front().Column[n]);
    CHECK(std::abs(gridded.Horizons.front().RealZ[n] - 0.1 * place.x()) < 1e-6);
  }
  // Twice at one place: between them, and nearer to what there is more of.
  picks = Scatter(300, Plane);
  picks.X[1] = picks.X[2] = picks.X[0];
  picks.Y[1] = picks.Y[2] = picks.Y[0];
  picks.Z[1] = picks.Z[2] = picks.Z[0] + 9.0;
  CHECK_EQUAL(GridPicks(picks, GriddingOptions()).Horizons.size(), std::size_t(1));
}

/// Horizons by their names, picks without z, and line numbers as places.
void TestTables()
{
  PickTable picks = Scatter(200, Plane);
  picks.Names = { "Top", "None", "Base" };
  for (std::size_t n = 0; n < picks.Size(); ++n)
  {
    picks.Horizon.push_back(n % 2 == 0 ? 0 : 2);
    picks.Z[n] += n % 2 == 0 ? 0.0 : 500.0;
  }
  picks.Z[4] = std::nan("");
  const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Plate));
  CHECK_EQUAL(gridded.Horizons.size(), std::size_t(3));
  CHECK_EQUAL(gridded.Horizons[0].DroppedNulls, std::int64_t(1));
  CHECK(gridded.Horizons[1].RealZ.empty());
  CHECK_EQUAL(gridded.Horizons[2].SurfaceId, 3);
  std::swap(picks.X, picks.Crossline);
  std::swap(picks.Y, picks.Inline);
  const SurveyHorizons ofLines = GridPicks(picks, Turned(GriddingMethod::Plate));
  CHECK(std::equal(ofLines.Horizons[0].RealZ.begin(), ofLines.Horizons[0].RealZ.end(),
    gridded.Horizons[0].RealZ.begin(), gridded.Horizons[0].RealZ.end()));
}

/// Least and greatest z, also of what is not finite.
std::pair<double, double> RangeOf(const LatticeHorizon& horizon)
{
  std::pair<double, double> range(horizon.RealZ[0], horizon.RealZ[0]);
  for (const double z : horizon.RealZ)
  {
    range = { z >= range.first ? range.first : z, z <= range.second ? range.second : z };
  }
  return range;
}

void TestThreads()
{
  const PickTable picks = Scatter(500, [](double x, double y) { return std::sin(x / 300.0) * y; });
  const int usual = Detail::NumberOfThreads();
  std::vector<double> alone;
  for (const int threads : { 1, 2, 5 })
  {
    Detail::NumberOfThreads() = threads;
    const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Plate));
    const HeapArray<double>& heights = gridded.Horizons.front().RealZ;
    alone = alone.empty() ? std::vector<double>(heights.begin(), heights.end()) : alone;
    CHECK(std::equal(alone.begin(), alone.end(), heights.begin(), heights.end()));
  }
  Detail::NumberOfThreads() = usual;
  GriddingOptions narrow = Turned(GriddingMethod::Plate);
  narrow.Placement.RowStep /= 16.0;
  const std::pair<double, double> range = RangeOf(GridPicks(picks, narrow).Horizons.front());
  CHECK(range.first > -6000.0 && range.second < 6000.0); // of picks within 2000
  narrow.Placement.RowStep *= 4.0;
  narrow.Placement.ColumnStep /= 4.0;
  CHECK_EQUAL(
    MonitorChecker::Check(10, [&](const Monitor& monitor) { GridPicks(picks, narrow, monitor); }), std::string());
}

/// As many columns as multigrid takes, of few lines: it converges.
void TestManyColumns()
{
  PickTable picks;
  picks.Names = { "Top" };
  for (int line = 0; line < 6; ++line)
  {
    for (int n = 0; n < 600; ++n)
    {
      picks.X.push_back(line * 1000.0 + 0.3 * n);
      picks.Y.push_back(12.5 * n);
      picks.Z.push_back(Plane(picks.X.back(), picks.Y.back()) + 20.0 * std::sin(0.01 * n + line));
    }
  }
  GriddingOptions options;
  options.Placement.Source = LatticeSource::OriginAndSteps;
  options.Placement.ColumnStep = { 12.5, 0.0 };
  options.Placement.RowStep = { 0.0, 25.0 };
  const SurveyHorizons gridded = GridPicks(picks, options);
  const LatticeHorizon& horizon = gridded.Horizons.front();
  CHECK(horizon.RealZ.size() > 100000);
  const auto ends = std::minmax_element(horizon.RealZ.begin(), horizon.RealZ.end());
  CHECK(*ends.first > 600.0 && *ends.second < 3300.0);
}

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
      "1 of 2000 picks far from all others, line 73; expected StrayPicks that are left out, or LatticeSource");
    options.Placement.LeaveOutStrays = true;
    const SurveyHorizons gridded = GridPicks(stray, options);
    CHECK_EQUAL(gridded.Lattice.ColumnStep.x(), step);
    CHECK_EQUAL(gridded.Doubts.front(), std::string("1 stray picks left out: line 73"));
    CHECK_THROWS_WITH(GridPicks(stray, Turned(GriddingMethod::Plate)), "far from all others, line 73");
  }
  // Where the lattice is given, only a warning.
  picks.X[70] += 9000.0;
  const SurveyHorizons gridded = GridPicks(picks, Turned(GriddingMethod::Nearest));
  CHECK_EQUAL(gridded.Doubts.front(), std::string("1 picks far from all others, line 73: StrayPicks leaves them out"));
  // Another area is none, and of ten picks one that is far enough.
  picks = Scatter(2000, Plane);
  std::for_each(picks.X.begin(), picks.X.begin() + 400, [](double& x) { x += 20000.0; });
  CHECK(GridPicks(picks, GriddingOptions()).Doubts.empty());
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
      const std::vector<std::string> doubts = FindDoubts(GridPicks(picks, Turned(method)));
      CHECK_EQUAL(doubts.size(), std::size_t(1));
      CHECK(!doubts.empty() && doubts.front().find("1 of 500 picks with z " + said) == 0);
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

void TestErrors()
{
  PickTable picks = Scatter(100, Plane);
  GriddingOptions options;
  options.Radius = -1.0;
  CHECK_THROWS_WITH(GridPicks(picks, options), "GriddingRadius -1, expected 0 to 1e+12 world units");
  options.Radius = 1e9;
  CHECK_THROWS_WITH(GridPicks(picks, options), "expected at most 1000 columns a pick and 2^28 in all: choose longer");
  options = GriddingOptions();
  options.Smoothing = std::nan("");
  CHECK_THROWS_WITH(GridPicks(picks, options), "GriddingSmoothing nan, expected 0 to 1e+06");
  options = Turned(GriddingMethod::Plate);
  options.Placement.RowStep = 2.0 * options.Placement.ColumnStep;
  CHECK_THROWS_WITH(GridPicks(picks, options), "RowStep");
  options.Placement.Source = LatticeSource::CornerPoints;
  CHECK_THROWS_WITH(GridPicks(picks, options), "expected");
  std::fill(picks.Z.begin(), picks.Z.end(), std::nan(""));
  CHECK_THROWS_WITH(GridPicks(picks, GriddingOptions()), "0 picks with z, expected at least 1");
}
}

int TestGridding(int, char*[])
{
  TestPlane();
  TestNearest();
  TestSmoothSurface();
  TestFewPicks();
  TestTables();
  TestThreads();
  TestManyColumns();
  TestWells();
  TestCrookedLine();
  TestStrays();
  TestNulls();
  TestDuplicates();
  TestOrder();
  TestSteps();
  TestClusters();
  TestErrors();
  return Check::Result();
}
