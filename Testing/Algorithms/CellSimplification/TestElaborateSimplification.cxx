// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSimplification/ElaborateSimplification.h"
#include "CellSimplification/Flatness.h"
#include "CellSimplification/RoughSimplification.h"
#include "Common/Parallel.h"
#include "Generator/HorizonGenerator.h"
#include "Tools/Check.h"
#include "Tools/MeshChecker.h"
#include "Tools/MonitorChecker.h"
#include "Tools/ReductionChecker.h"
#include "Triangulation/Triangulation.h"

#include <functional>
#include <map>
#include <set>
#include <utility>

using namespace ReductionChecker;

namespace
{
using Height = std::function<double(int, int)>;

double Slope(int x, int y)
{
  return 0.125 * x + 0.0625 * y; // below 8 for all squares here: one layer
}

BoundedHorizon Square(int size, const Height& height = Slope)
{
  const Patches::Columns columns =
    Patches::FromPicture(std::vector<std::string>(std::size_t(size), std::string(std::size_t(size), '#')));
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(height(column.X, column.Y));
  }
  return MakeHorizon(columns, heights);
}

BoundedHorizon LevelSquare(int size)
{
  return Square(size, [](int, int) { return 0.0; });
}

PlanePoint Column(double x, double y)
{
  return { std::int32_t(x * SubVoxelsPerColumn), std::int32_t(y * SubVoxelsPerColumn) };
}

/// How many output points come from cells of each level: level -> number, of a ring and a kind.
std::map<int, int> CountLevels(const Reduction& result, int ring, PointKind kind)
{
  std::map<int, int> levels;
  for (const PointOrigin& origin : result.Origin)
  {
    levels[origin.Level] += origin.Ring == ring && origin.Kind == kind ? 1 : 0;
  }
  for (auto level = levels.begin(); level != levels.end();)
  {
    level = level->second == 0 ? levels.erase(level) : std::next(level);
  }
  return levels;
}

using Levels = std::map<int, int>;

int DeepestLevel(const Reduction& result)
{
  int level = 0;
  for (const PointOrigin& origin : result.Origin)
  {
    level = std::max(level, int(origin.Level));
  }
  return level;
}

/// Eight by eight, one cell: 28 boundary points in 8 columns, and far apart. It stays whole: its boundary points, and
/// one for the other 36.
void TestDenseBoundaryCellStaysWhole()
{
  const BoundedHorizon horizon = Square(8);
  const Reduction result = SimplifyElaborate(horizon, 8);
  CHECK_EQUAL(result.Source.size(), 29u);
  CHECK(result.Plane.back() == Column(3.5, 3.5));
  CHECK_EQUAL(result.Height.back(), Slope(7, 7) / 2.0);
  CHECK_EQUAL(Reduce(horizon, result).Count.back(), 36);
  CHECK((CountLevels(result, 1, PointKind::Boundary) == Levels{ { 0, 28 } }));
  CHECK((CountLevels(result, 1, PointKind::Barycentre) == Levels{ { 0, 1 } }));
}

/// The same, but a cell of 8 does not count as large: its inner points go, and count for their nearest neighbours.
void TestSmallBoundaryCellKeepsBoundaryOnly()
{
  ElaborateOptions options;
  options.BoundaryCellSizeThreshold = 8.0;
  const BoundedHorizon horizon = Square(8);
  const Reduction result = SimplifyElaborate(horizon, options);
  CHECK_EQUAL(result.Source.size(), 28u);
  CHECK_EQUAL(result.Target[8 + 1], result.Target[1]); // as near to (0, 1) as to (1, 0): the first
}

/// The same, with criteria that are never met. Each quarter is cut into the four columns of its corner, two cells of
/// two at the border, cut to columns, too, and one inside, which has no boundary points and is flat.
void TestSparseBoundaryCellIsHalved()
{
  ElaborateOptions dense;
  dense.BoundaryDensityThreshold = 4.0;
  ElaborateOptions wide;
  wide.BoundaryExtentThreshold = 100.0;
  ElaborateOptions justWide; // the diagonal, as exactly as it gets
  justWide.BoundaryExtentThreshold = std::sqrt(2.0 * 49.0 + Slope(7, 7) * Slope(7, 7));
  for (const ElaborateOptions& options : { dense, wide, justWide })
  {
    const Reduction result = SimplifyElaborate(Square(8), options);
    CHECK_EQUAL(result.Source.size(), 28u + 4u * 5u + 4u);
    CHECK((CountLevels(result, 1, PointKind::Boundary) == Levels{ { 3, 28 } }));
    CHECK((CountLevels(result, 1, PointKind::InputPoint) == Levels{ { 3, 20 } }));
    CHECK((CountLevels(result, 1, PointKind::Barycentre) == Levels{ { 2, 4 } }));
  }
}

/// Nine by nine: the corner (8, 8) is alone in its cell. It has no extent, and is halved until it is a column.
void TestSingleBoundaryPointEnds()
{
  const Reduction result = SimplifyElaborate(Square(9), 8);
  CHECK_EQUAL(int(result.Origin[std::size_t(result.Target[80])].Level), 3);
}

/// A side of 10 can be halved three times, to 1.25: a fourth time it would be less than a column. One of 3 only once.
void TestNeverBelowOneColumn()
{
  ElaborateOptions options(10);
  options.BoundaryExtentThreshold = 100.0;
  CHECK_EQUAL(DeepestLevel(SimplifyElaborate(Square(10), options)), 3);
  options.CellSize = 3;
  CHECK_EQUAL(DeepestLevel(SimplifyElaborate(Square(10), options)), 1);
  options.CellSize = 1;
  CHECK_EQUAL(DeepestLevel(SimplifyElaborate(Square(10), options)), 0);
  CHECK_EQUAL(SimplifyElaborate(Square(10), options).Source.size(), 100u);
}

/// Three by three cells on a plane. All stay whole: boundary points, a barycentre in each cell, the middle one second.
void TestFlatInnerCell()
{
  const BoundedHorizon horizon = Square(24);
  const Reduction result = SimplifyElaborate(horizon, 8);
  CHECK_EQUAL(result.Source.size(), 92u + 9u);
  CHECK((CountLevels(result, 2, PointKind::Barycentre) == Levels{ { 0, 1 } }));
  const std::size_t middle = std::size_t(result.Target[12 * 24 + 12]);
  CHECK(result.Plane[middle] == Column(11.5, 11.5));
  CHECK_EQUAL(result.Height[middle], 0.5 * (Slope(11, 11) + Slope(12, 12)));
  CHECK_EQUAL(result.Origin[middle].Ring, 2);
  CHECK_EQUAL(Reduce(horizon, result).Count[middle], 64);
}

/// Three by three cells again. Corners, with 15 boundary points, stay whole; the four sides, with 8, do not: 2 pieces
/// of 4, 4 of 2 and 16 columns each, whose mean is 32 / 22 = 1.45. Each cube around the middle counts once: (4 * 8 +
/// 4 * 1.45) / 8 = 4.73. So the middle is cut to pieces of 4, and with growth 2 (9.45) it stays whole.
void TestInnerCellFollowsItsNeighbours()
{
  ElaborateOptions options;
  options.BoundaryDensityThreshold = 1.0;
  const Reduction pieces = SimplifyElaborate(LevelSquare(24), options);
  CHECK((CountLevels(pieces, 2, PointKind::Barycentre) == Levels{ { 1, 4 } }));
  CHECK((CountLevels(pieces, 1, PointKind::Barycentre) == Levels{ { 0, 4 }, { 1, 8 }, { 2, 16 } }));
  options.GrowthPerRing = 2.0;
  CHECK((CountLevels(SimplifyElaborate(LevelSquare(24), options), 2, PointKind::Barycentre) == Levels{ { 0, 1 } }));
}

/// The same, but each piece around the middle counts: (4 * 8 + 4 * 32) / (4 * 1 + 4 * 22) = 1.74. So the middle is cut
/// to pieces of 2, with growth 2 (3.48) to pieces of 4, and with growth 5 (8.7) it stays whole.
void TestInnerCellFollowsPieces()
{
  ElaborateOptions options;
  options.BoundaryDensityThreshold = 1.0;
  options.NeighbourMean = NeighbourMeanKind::OverPieces;
  CHECK((CountLevels(SimplifyElaborate(LevelSquare(24), options), 2, PointKind::Barycentre) == Levels{ { 2, 16 } }));
  options.GrowthPerRing = 2.0;
  CHECK((CountLevels(SimplifyElaborate(LevelSquare(24), options), 2, PointKind::Barycentre) == Levels{ { 1, 4 } }));
  options.GrowthPerRing = 5.0;
  CHECK((CountLevels(SimplifyElaborate(LevelSquare(24), options), 2, PointKind::Barycentre) == Levels{ { 0, 1 } }));
}

/// The same, but corners are cut, too: one piece of 4, 5 of 2 and 28 columns each, 42 / 34 = 1.24. Over cubes the mean
/// is (1.24 + 1.45) / 2 = 1.34, over pieces (4 * 42 + 4 * 32) / (4 * 34 + 4 * 22) = 1.32; both are nearer to 1 than to
/// 2: columns.
void TestInnerCellFollowsItsNeighboursToColumns()
{
  ElaborateOptions options;
  options.BoundaryDensityThreshold = 4.0;
  for (const NeighbourMeanKind mean : { NeighbourMeanKind::OverCubes, NeighbourMeanKind::OverPieces })
  {
    options.NeighbourMean = mean;
    const Reduction result = SimplifyElaborate(LevelSquare(24), options);
    CHECK((CountLevels(result, 2, PointKind::InputPoint) == Levels{ { 3, 64 } }));
  }
}

/// Cells of 10 with criteria that are never met are halved to 5, 2.5 and 1.25, as far as they may.
void TestSmallestCellSize()
{
  ElaborateOptions options(10);
  options.BoundaryExtentThreshold = 100.0;
  const std::pair<double, int> deepest[] = { { 1.0, 3 }, { 1.25, 3 }, { 1.26, 2 }, { 2.5, 2 }, { 3.0, 1 }, { 5.0, 1 },
    { 5.5, 0 }, { 100.0, 0 } };
  for (const auto& [smallest, level] : deepest)
  {
    options.SmallestCellSize = smallest;
    CHECK_EQUAL(DeepestLevel(SimplifyElaborate(Square(20), options)), level);
  }
  // Curvature, and the size of neighbours, end there, too.
  const BoundedHorizon twisted = Square(32, [](int x, int y) { return 0.0005 * x * y; });
  ElaborateOptions curved(8, 0.0);
  curved.SmallestCellSize = 2.0;
  CHECK((CountLevels(SimplifyElaborate(twisted, curved), 2, PointKind::Barycentre) == Levels{ { 2, 64 } }));
  ElaborateOptions sparse;
  sparse.BoundaryDensityThreshold = 4.0;
  sparse.SmallestCellSize = 4.0;
  CHECK((CountLevels(SimplifyElaborate(LevelSquare(24), sparse), 2, PointKind::Barycentre) == Levels{ { 1, 4 } }));
}

/// A step through the middle of the middle cell: its halves are level. Flat enough as a whole for a third at most.
void TestCurvedInnerCellIsHalved()
{
  const BoundedHorizon horizon = Square(24, [](int x, int) { return x < 12 ? 0.0 : 1.0; });
  const Reduction cut = SimplifyElaborate(horizon, ElaborateOptions(8, 0.0));
  CHECK((CountLevels(cut, 2, PointKind::Barycentre) == Levels{ { 1, 4 } }));
  const Reduction whole = SimplifyElaborate(horizon, ElaborateOptions(8, 1.0 / 3.0));
  CHECK((CountLevels(whole, 2, PointKind::Barycentre) == Levels{ { 0, 1 } }));
}

/// Cells are cubes: the step is 20 high, so that the sides of it are in layers that do not touch. The upper half of the
/// middle cell is reached from its upper neighbours.
void TestLayersAreApart()
{
  const BoundedHorizon horizon = Square(24, [](int x, int) { return x < 12 ? 0.0 : 20.0; });
  const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(8, 1.0 / 3.0));
  CHECK((CountLevels(result, 2, PointKind::Barycentre) == Levels{ { 0, 2 } }));
  CHECK_EQUAL(CheckCells(horizon, result, 8, true), std::string());
}

/// A plateau of one cell, far above all others: no cell touches it. It comes after the ring around it, and follows
/// that.
void TestCellBeyondACliff()
{
  const BoundedHorizon horizon = Square(40, [](int x, int y) { return x / 8 == 2 && y / 8 == 2 ? 100.0 : 0.0; });
  const Reduction result = SimplifyElaborate(horizon, 8);
  CHECK((CountLevels(result, 3, PointKind::Barycentre) == Levels{ { 0, 1 } }));
  ElaborateOptions sparse;
  sparse.BoundaryDensityThreshold = 4.0; // ring 2 is cut to columns at its corners, and to pieces of 2 at its sides
  CHECK((CountLevels(SimplifyElaborate(horizon, sparse), 3, PointKind::Barycentre) == Levels{ { 2, 16 } }));
  sparse.NeighbourMean = NeighbourMeanKind::OverPieces; // of which there are more at the corners
  CHECK((CountLevels(SimplifyElaborate(horizon, sparse), 3, PointKind::InputPoint) == Levels{ { 3, 64 } }));
}

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

/// In a C of one cell the barycentre of the inner points lies in the opening; the nearest of them stands for the cell.
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

/// No cell of the second ring is larger than the threshold lets it: with 0 a twisted surface goes down to columns.
void TestFlatnessZeroGoesDownToColumns()
{
  const BoundedHorizon horizon = Square(32, [](int x, int y) { return 0.0005 * x * y; });
  const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(8, 0.0));
  CHECK((CountLevels(result, 2, PointKind::InputPoint) == Levels{ { 3, 256 } }));
  const Reduction one = SimplifyElaborate(horizon, ElaborateOptions(8, 1.0 / 3.0));
  CHECK((CountLevels(one, 2, PointKind::Barycentre) == Levels{ { 0, 4 } }));
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

/// Every point lies in just one of the listed cells.
void TestListedCells()
{
  const BoundedHorizon horizon = Square(40, [](int x, int y) { return 0.02 * x * y; });
  ElaborateOptions options(8, 0.001);
  options.ListCells = true;
  const Reduction result = SimplifyElaborate(horizon, options);
  const auto contains = [](double low, double size, double x) { return x >= low && x < low + size; };
  std::set<double> sizes;
  for (const SpacePoint& place : ToSpacePoints(horizon))
  {
    CHECK_EQUAL(std::count_if(result.Cells.begin(), result.Cells.end(),
                  [&](const SimplificationCell& cell)
                  {
                    return contains(cell.Low.X, cell.Size, place.X) && contains(cell.Low.Y, cell.Size, place.Y) &&
                      contains(cell.Low.Z, cell.Size, place.Z);
                  }),
      1);
  }
  std::int64_t points = 0;
  for (const SimplificationCell& cell : result.Cells)
  {
    points += cell.Points;
    sizes.insert(cell.Size);
    CHECK_EQUAL(cell.Size, std::ldexp(8.0, -int(cell.Origin.Level)));
  }
  CHECK_EQUAL(points, 1600);
  CHECK(sizes.size() > 1);
}

/// A checkerboard of heights 0 and 1 in the middle cell: its 64 places vary by (64 - 1) / 12 along both axes, heights
/// by 1 / 4. All others are on a plane.
void TestFlatnessOfCells()
{
  const BoundedHorizon horizon =
    Square(24, [](int x, int y) { return x / 8 == 1 && y / 8 == 1 ? double((x + y) % 2) : 0.0; });
  ElaborateOptions options(8, 1.0 / 3.0);
  options.ListCells = true;
  const Reduction result = SimplifyElaborate(horizon, options);
  const double middle = 0.25 / (0.25 + 2.0 * 63.0 / 12.0);
  CHECK_EQUAL(result.Flatness.size(), result.Source.size());
  for (std::size_t point = 0; point < result.Flatness.size(); ++point)
  {
    CHECK(std::abs(result.Flatness[point] - (result.Origin[point].Ring == 2 ? middle : 0.0)) < 1e-6);
  }
  for (const SimplificationCell& cell : result.Cells)
  {
    CHECK(std::abs(cell.Flatness - (cell.Origin.Ring == 2 ? middle : 0.0)) < 1e-6);
  }
}

/// Boundary points and the point that stands for the others of their cell have one flatness, that of all its points;
/// and no inner cell is less flat than the threshold lets it, unless it is the smallest.
void TestFlatnessIsThatOfTheCell()
{
  const BoundedHorizon horizon = Square(40, [](int x, int y) { return double((x * x + 3 * y * y) % 7) / 2.0; });
  const double threshold = 0.02;
  const Reduction result = SimplifyElaborate(horizon, ElaborateOptions(8, threshold));
  std::map<std::pair<int, int>, std::set<double>> values; // by cube, of those that are whole
  for (std::size_t point = 0; point < result.Flatness.size(); ++point)
  {
    const PointOrigin& origin = result.Origin[point];
    const PlanePoint cube = { result.Plane[point].X / Column(8, 0).X, result.Plane[point].Y / Column(8, 0).X };
    if (origin.Ring == 1 && origin.Level == 0)
    {
      values[{ cube.X, cube.Y }].insert(result.Flatness[point]);
    }
    CHECK(origin.Ring == 1 || origin.Level == 3 || result.Flatness[point] <= threshold + 1e-6);
  }
  CHECK_EQUAL(values.size(), 16u);
  for (const auto& [cube, flatness] : values)
  {
    CHECK_EQUAL(flatness.size(), 1u);
    CHECK(*flatness.begin() > threshold);
  }
}

void TestFlatness()
{
  Eigen::Matrix3d covariance = Eigen::Vector3d(0.25, 1.0, 0.75).asDiagonal();
  CHECK(std::abs(Flatness(covariance) - 0.125) < 1e-15);
  CHECK(IsFlatWithin(covariance, 0.125));
  CHECK(!IsFlatWithin(covariance, 0.125 - 1e-9));
  covariance.setIdentity();
  CHECK(IsFlatWithin(covariance, 1.0 / 3.0));
  CHECK(!IsFlatWithin(covariance, 0.3));
  CHECK(IsFlatWithin(Eigen::Matrix3d::Zero(), 0.0)); // one place
  // A line, which the closed formula has trouble with, and a plane in no special position.
  const Eigen::Vector3d along(1.0, 2.0, 3.0);
  const Eigen::Vector3d across(3.0, 0.0, -1.0);
  CHECK(IsFlatWithin(along * along.transpose(), 0.0));
  CHECK(IsFlatWithin(along * along.transpose() + 1e-3 * across * across.transpose(), 0.0));
  for (const double squeeze : { 0.0, 1e-9, 0.001, 0.5, 1.0 })
  {
    covariance = Eigen::Vector3d(squeeze, 1.0, squeeze).asDiagonal();
    CHECK(std::abs(QuickFlatness(covariance) - squeeze / (1.0 + 2.0 * squeeze)) < 1e-7);
    CHECK(QuickFlatness(covariance) >= 0.0);
  }
}

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
  const HorizonVoxels voxels = HorizonGenerator(generator).MakeHorizon(0);
  Patches::Columns columns;
  for (std::size_t n = 0; n < voxels.I.size(); ++n)
  {
    columns.push_back({ voxels.I[n], voxels.J[n] });
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
}

int TestElaborateSimplification(int, char*[])
{
  TestDenseBoundaryCellStaysWhole();
  TestSmallBoundaryCellKeepsBoundaryOnly();
  TestSparseBoundaryCellIsHalved();
  TestSingleBoundaryPointEnds();
  TestNeverBelowOneColumn();
  TestFlatInnerCell();
  TestInnerCellFollowsItsNeighbours();
  TestInnerCellFollowsPieces();
  TestInnerCellFollowsItsNeighboursToColumns();
  TestSmallestCellSize();
  TestCurvedInnerCellIsHalved();
  TestLayersAreApart();
  TestCellBeyondACliff();
  TestPointsAboveEachOther();
  TestBarycentreOutside();
  TestPointsAreWeighted();
  TestNearestPointStandsForTheCell();
  TestFlatnessZeroGoesDownToColumns();
  TestPlaneStaysAPlane();
  TestListedCells();
  TestFlatnessOfCells();
  TestFlatnessIsThatOfTheCell();
  TestFlatness();
  TestRandomPatches();
  TestGeneratedHorizon();
  TestNumberOfThreads();
  TestErrorsAndAbort();
  TestManyLayers();
  TestEmpty();
  return Check::Result();
}
