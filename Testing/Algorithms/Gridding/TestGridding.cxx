// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Parallel.h"
#include "GriddingFixtures.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace GriddingFixtures;

namespace
{
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

/// Picks lie in all directions, without a gap of 180 degrees.
bool IsBetween(const PickTable& picks, const Eigen::Vector2d& place)
{
  std::vector<double> directions;
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    directions.push_back(std::atan2(picks.Y[pick] - place.y(), picks.X[pick] - place.x()));
  }
  std::sort(directions.begin(), directions.end());
  constexpr double halfTurn = 3.14159265358979323846;
  double widest = directions.front() + 2.0 * halfTurn - directions.back();
  for (std::size_t n = 1; n < directions.size(); ++n)
  {
    widest = std::max(widest, directions[n] - directions[n - 1]);
  }
  return widest < halfTurn;
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
  int outside = 0;
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
        const double filled = AttributeOf(horizon, "Filled")[column->second];
        CHECK_EQUAL(filled == 0.0, count > 0.0);
        CHECK_EQUAL(filled == 2.0, count == 0.0 && !IsBetween(picks, place));
        outside += filled == 2.0 ? 1 : 0;
        pickCount += count;
      }
    }
  }
  CHECK_EQUAL(pickCount, 200.0);
  CHECK(outside > 100);
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
  TestErrors();
  return Check::Result();
}
