// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The elaborate simplification: the points that stand for cells, whole horizons, and errors.

#include "Common/Base/Parallel.h"
#include "Common/Horizon/MeshChecker.h"
#include "ElaborateFixtures.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Generator/HorizonGenerator.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace ElaborateFixtures;

namespace
{
// ---- Points that stand for cells ---------------------------------------------------------------------------------
/// The middle cell is a checkerboard of two layers, so that both barycentres are in its middle. Both layers take an
/// input point instead.
void TestPointsAboveEachOther()
{
  const auto height = [](int x, int y) { return x / 8 == 1 && y / 8 == 1 && (x + y) % 2 == 1 ? 20.0 : 0.0; };
  const BoundedHorizon horizon = Square(24, height);
  const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(8, 1.0 / 3.0));
  CHECK_EQUAL(CheckPoints(horizon, result), std::string());
  const std::size_t low = std::size_t(result.Target[12 * 24 + 12]);
  const std::size_t high = std::size_t(result.Target[12 * 24 + 11]);
  CHECK(result.Plane[low] == Column(11, 11));
  CHECK(result.Plane[high] == Column(12, 11));
  CHECK_EQUAL(result.Height[low], 0.0);
  CHECK_EQUAL(result.Height[high], 20.0);
  CHECK_EQUAL(Reduce(horizon, result).Count[high], 32);
  // Steps of 5 fit into one cube, whose octants are above each other then.
  const BoundedHorizon rough = Square(24, [&](int x, int y) { return 0.25 * height(x, y); });
  const Reduction octants = SimplifyElaborate(rough, 8);
  CHECK_EQUAL(CheckPoints(rough, octants), std::string());
  CHECK((CountLevels(octants, 2, PointKind::InputPoint) == Levels{ { 1, 8 } }));
}

/// In a C of one cell the barycentre of the inner points lies in the opening; the nearest of them represents the cell.
void TestBarycentreOutside()
{
  const std::vector<std::string> picture = { "###########", "###########", "###########", "###", "###", "###",
    "###########", "###########", "###########" };
  const Patches::Columns columns = Patches::FromPicture(picture);
  const BoundedHorizon horizon = MakeHorizon(columns, std::vector<double>(columns.size(), 0.0));
  const Reduction result = SimplifyElaborate(horizon, 16);
  CHECK_EQUAL(CheckPoints(horizon, result), std::string());
  CHECK((CountLevels(result, 1, PointKind::InputPoint) == Levels{ { 0, 1 } }));
}

/// Heavy points weigh more, in both places: the barycentre and the curvature.
void TestPointsAreWeighted()
{
  BoundedHorizon horizon = Square(24);
  horizon.Count[8 * 24 + 8] = 65;
  const Reduction result = SimplifyElaborate(horizon, 8);
  const std::size_t middle = std::size_t(result.Target[12 * 24 + 12]);
  CHECK(result.Plane[middle] == Column(9.75, 9.75)); // halfway from the mean to the heavy point
  horizon.Count.assign(horizon.Count.size(), 0); // nonsense, but no reason to divide by 0
  CHECK_EQUAL(SimplifyElaborate(horizon, 8).Source.size(), result.Source.size());
  CHECK_EQUAL(SimplifyRough(horizon, 8).Source.size(), 93u);
}

void TestNearestPointStandsForTheCell()
{
  ElaborateOptions options;
  options.Representative = RepresentativeKind::NearestPoint;
  const BoundedHorizon horizon = Square(24);
  const Reduction result = SimplifyElaborate(horizon, options);
  CHECK_EQUAL(CheckPoints(horizon, result), std::string());
  CHECK_EQUAL(std::count(result.Averaged.begin(), result.Averaged.end(), 1), 0);
  const std::size_t middle = std::size_t(result.Target[12 * 24 + 12]);
  CHECK(result.Plane[middle] == Column(11, 11)); // as near as three others; the first
  CHECK_EQUAL(result.Height[middle], Slope(11, 11));
}

void TestPlaneStaysAPlane()
{
  const BoundedHorizon horizon = Square(40);
  for (const int size : { 2, 3, 8, 10 })
  {
    const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(size, 0.0));
    for (std::size_t point = 0; point < result.Plane.size(); ++point)
    {
      const double plane = (0.125 * result.Plane[point].X + 0.0625 * result.Plane[point].Y) / SubVoxelsPerColumn;
      CHECK(std::abs(result.Height[point] - plane) < 1.0 / SubVoxelsPerColumn);
    }
  }
}

// ---- Whole horizons ----------------------------------------------------------------------------------------------
void TestRandomPatches()
{
  Patches::Random random(11);
  for (int n = 0; n < 2000; ++n)
  {
    const Patches::Columns columns =
      MovedToOrigin(Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random));
    std::vector<double> heights = MakeHeights(columns, random);
    const double scale = n % 3 == 0 ? 6.0 : 1.0; // steep: several layers
    std::transform(heights.begin(), heights.end(), heights.begin(), [scale](double z) { return scale * z; });
    const BoundedHorizon full = MakeHorizon(columns, heights);
    const BoundedHorizon horizon = Drop(full, SimplifyBoundary(full, full.Boundary, 3.0 * random.Fraction()));
    ElaborateOptions options(1 + random.Below(11), 0.34 * random.Fraction());
    options.BoundaryDensityThreshold = random.Fraction();
    options.BoundaryExtentThreshold = 4.0 * random.Fraction();
    options.BoundaryCellSizeThreshold = 4.0 * random.Fraction();
    options.GrowthPerRing = 1.0 + random.Fraction();
    options.SmallestCellSize = 1.0 + 2.0 * random.Fraction();
    options.NeighbourMean = NeighbourMeanKind(n % 5 == 0);
    options.Representative = RepresentativeKind(n % 7 == 0);
    const BoundedHorizon input = n % 2 == 0 ? horizon : Reduce(horizon, SimplifyRough(horizon, 1 + random.Below(3)));
    const Reduction result = SimplifyElaborate(input, options);
    CHECK_EQUAL(CheckPoints(input, result), std::string());
    CHECK_EQUAL(CheckCells(input, result, options.CellSize, true), std::string());
    const BoundedHorizon reduced = Reduce(input, result);
    CHECK_EQUAL(MeshChecker::CheckMesh(reduced, Triangulate(reduced).Triangles), std::string());
  }
}

/// A horizon with bays, holes, islands and missing voxels: the whole way, and each step alone.
void TestGeneratedHorizon()
{
  HorizonGeneratorOptions generator;
  generator.NumberOfHorizons = 1;
  const LatticeHorizon voxels = HorizonGenerator(generator).MakeHorizon(0);
  Patches::Columns columns;
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    columns.push_back({ voxels.Column[n].X, voxels.Column[n].Y });
  }
  const std::vector<double> heights(voxels.K.begin(), voxels.K.end());
  const BoundedHorizon full = MakeHorizon(MovedToOrigin(columns), heights);
  const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 0.4));
  const BoundedHorizon rough = Reduce(straight, SimplifyRough(straight, 3));
  std::size_t before = full.Plane.size();
  for (const double flatness : { 0.0, 0.03, 0.2 })
  {
    const Reduction alone = SimplifyElaborate(straight, ElaborateOptions(8, flatness));
    CHECK_EQUAL(CheckPoints(straight, alone), std::string());
    CHECK_EQUAL(CheckCells(straight, alone, 8, true), std::string());
    CHECK(alone.Source.size() <= before); // a larger threshold leaves no more points
    before = alone.Source.size();
    const Reduction after = SimplifyElaborate(rough, ElaborateOptions(10, flatness));
    CHECK_EQUAL(CheckPoints(rough, after), std::string());
    CHECK(after.Source.size() < rough.Plane.size());
  }
}

/// Enough cells for many threads.
void TestNumberOfThreads()
{
  int& threads = SeismicHorizons::Detail::NumberOfThreads();
  const int usual = threads;
  const BoundedHorizon horizon =
    Square(400, [](int x, int y) { return 20.0 * std::sin(0.05 * x) * std::cos(0.04 * y); });
  threads = 1;
  const Reduction rough = SimplifyRough(horizon, 3);
  const Reduction elaborate = SimplifyElaborate(horizon, ElaborateOptions(8, 0.002));
  for (const int number : { 2, 3, 8 })
  {
    threads = number;
    CHECK(IsSame(rough, SimplifyRough(horizon, 3)));
    CHECK(IsSame(elaborate, SimplifyElaborate(horizon, ElaborateOptions(8, 0.002))));
  }
  threads = usual;
}

/// Heights without any order: hundreds of layers above one cell, none of which touches another. Each cube must not look
/// at all others: 90,000 points took half a minute when they did.
void TestManyLayers()
{
  Patches::Columns columns;
  std::vector<double> heights;
  Patches::Random random(8);
  for (std::int32_t n = 0; n < 90000; ++n)
  {
    columns.push_back({ n % 300, n / 300 });
    heights.push_back(1e9 * random.Fraction());
  }
  const BoundedHorizon horizon = MakeHorizon(columns, heights);
  const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(300));
  CHECK_EQUAL(CheckPoints(horizon, result), std::string());
}

void TestEmpty()
{
  CHECK(SimplifyElaborate(BoundedHorizon(), ElaborateOptions()).Source.empty());
}

void TestErrorsAndAbort()
{
  const BoundedHorizon horizon = Square(24);
  const auto refuses = [&](double ElaborateOptions::*option, double value, const char* message)
  {
    ElaborateOptions options;
    options.*option = value;
    CHECK_THROWS_WITH(SimplifyElaborate(horizon, options), message);
  };
  CHECK_THROWS_WITH(SimplifyElaborate(horizon, 0), "cell size 0, expected at least 1 column");
  refuses(&ElaborateOptions::FlatnessThreshold, -0.5, "flatness threshold -0.5, expected at least 0 (a plane)");
  refuses(&ElaborateOptions::FlatnessThreshold, std::nan(""), "flatness threshold nan");
  refuses(
    &ElaborateOptions::BoundaryDensityThreshold, -1.0, "boundary density threshold -1, expected at least 0 points");
  refuses(
    &ElaborateOptions::BoundaryExtentThreshold, -1.0, "boundary extent threshold -1, expected at least 0 lattice");
  refuses(&ElaborateOptions::BoundaryCellSizeThreshold, -1.0, "boundary cell size threshold -1, expected at least 0 l");
  refuses(&ElaborateOptions::SmallestCellSize, 0.5, "smallest cell size 0.5, expected at least 1 column");
  refuses(&ElaborateOptions::SmallestCellSize, std::nan(""), "smallest cell size nan, expected a finite number");
  refuses(&ElaborateOptions::GrowthPerRing, 0.5, "growth per ring 0.5, expected at least 1 (cells as large as");
  CHECK_EQUAL(
    MonitorChecker::Check(9, [&](const Monitor& monitor) { SimplifyElaborate(horizon, 8, monitor); }), std::string());
}
}

int TestElaborateSimplification(int, char*[])
{
  TestPointsAboveEachOther();
  TestBarycentreOutside();
  TestPointsAreWeighted();
  TestNearestPointStandsForTheCell();
  TestPlaneStaysAPlane();
  TestRandomPatches();
  TestGeneratedHorizon();
  TestNumberOfThreads();
  TestErrorsAndAbort();
  TestManyLayers();
  TestEmpty();
  return Check::Result();
}
