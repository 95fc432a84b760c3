// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The elaborate simplification: how cells are halved, those of the boundary and those inside, ring by ring.

#include "ElaborateFixtures.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace ElaborateFixtures;

namespace
{
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
}

int TestElaborateCells(int, char*[])
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
  TestLayersAreApart();
  TestCellBeyondACliff();
  TestListedCells();
  return Check::Result();
}
