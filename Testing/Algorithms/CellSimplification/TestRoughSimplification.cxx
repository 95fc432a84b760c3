// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "Tools/ReductionChecker.h"

#include <algorithm>
#include <tuple>

using namespace ReductionChecker;

namespace
{
BoundedHorizon FromPicture(const std::vector<std::string>& picture)
{
  const Patches::Columns columns = Patches::FromPicture(picture);
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(column.X + 10.0 * column.Y);
  }
  return MakeHorizon(columns, heights);
}

std::vector<std::string> Square(int size)
{
  return std::vector<std::string>(std::size_t(size), std::string(std::size_t(size), '#'));
}

/// Six by six in cells of three: every cell touches the boundary, so that only the boundary is left.
void TestBoundaryCellsKeepTheirBoundaryOnly()
{
  const BoundedHorizon horizon = FromPicture(Square(6));
  const Reduction result = SimplifyRough(horizon, 3);
  CHECK_EQUAL(result.Source.size(), 20u);
  CHECK(std::none_of(result.Averaged.begin(), result.Averaged.end(), [](bool averaged) { return averaged; }));
  // Point (1, 1) is as near to (0, 1) as to (1, 0); the first of the two counts it.
  CHECK_EQUAL(result.Target[7], result.Target[1]);
}

/// Nine by nine in cells of three: the middle cell becomes its barycentre, the point (4, 4), which is on a plane.
void TestInnerCellBecomesItsBarycentre()
{
  const BoundedHorizon horizon = FromPicture(Square(9));
  const Reduction result = SimplifyRough(horizon, 3);
  CHECK_EQUAL(result.Source.size(), 33u);
  CHECK(result.Averaged.back());
  CHECK_EQUAL(result.Source.back(), 4 * 9 + 4);
  CHECK(result.Plane.back() == (PlanePoint{ 4 * SubVoxelsPerColumn, 4 * SubVoxelsPerColumn }));
  CHECK_EQUAL(result.Height.back(), 44.0);
  CHECK_EQUAL(Reduce(horizon, result).Count.back(), 9);
}

/// Columns that others own give what the same places in sub-voxels give.
void TestColumnsOfOthers()
{
  const BoundedHorizon horizon = FromPicture(Square(9));
  const Patches::Columns columns = Patches::FromPicture(Square(9));
  BoundedHorizon onColumns = horizon;
  onColumns.Plane.clear();
  onColumns.Columns = columns;
  const Reduction expected = SimplifyRough(horizon, 2);
  const Reduction result = SimplifyRough(onColumns, 2);
  CHECK(result.Plane == expected.Plane && result.Height == expected.Height && result.Target == expected.Target);
  CHECK(result.Source == expected.Source && result.Averaged == expected.Averaged);
}

/// Points weigh as much as they stand for; the fraction of a column is the nearest sub-voxel.
void TestBarycentreIsWeighted()
{
  BoundedHorizon horizon = FromPicture(Square(9));
  horizon.Count[3 * 9 + 3] = 3;
  const Reduction result = SimplifyRough(horizon, 3);
  // Eleven points, two of them added at (3, 3): 4 - 2 / 11 columns.
  const double expected = 4.0 - 2.0 / 11.0;
  CHECK(std::abs(double(result.Plane.back().X) / SubVoxelsPerColumn - expected) <= 0.5 / SubVoxelsPerColumn);
  CHECK(std::abs(result.Height.back() - 11.0 * expected) < 1e-12);
}

void TestCellsStartAtTheBoundingBox()
{
  BoundedHorizon horizon = FromPicture(Square(9));
  for (PlanePoint& place : horizon.Plane)
  {
    place = { place.X + 1000 * SubVoxelsPerColumn, place.Y + 77 * SubVoxelsPerColumn };
  }
  CHECK_EQUAL(SimplifyRough(horizon, 3).Source.size(), 33u);
}

void TestCellSizeOneChangesNothing()
{
  const BoundedHorizon horizon = FromPicture(Square(5));
  const Reduction result = SimplifyRough(horizon, 1);
  CHECK_EQUAL(result.Source.size(), 25u);
  for (std::size_t point = 0; point < 25; ++point)
  {
    CHECK_EQUAL(result.Source[std::size_t(result.Target[point])], PointId(point));
  }
}

void TestHugeCellsLeaveTheBoundary()
{
  const Reduction result = SimplifyRough(FromPicture(Square(9)), 2000000000);
  CHECK_EQUAL(result.Source.size(), 32u);
}

/// A narrow inlet runs through the middle of a cell that holds no point of it: long straight edges on both sides, and
/// the barycentre of what is left and right of it lies in the inlet. The nearest point represents the cell.
void TestBarycentreOutside()
{
  BoundedHorizon horizon;
  horizon.SubVoxelsPerColumn = SubVoxelsPerColumn;
  const auto add = [&horizon](int x, int y) {
    horizon.Plane.push_back({ x * SubVoxelsPerColumn, y * SubVoxelsPerColumn });
  };
  // A frame of 24 columns with an inlet from above between x = 15 and 17.
  const int outline[][2] = { { 0, 0 }, { 0, 24 }, { 15, 24 }, { 16, 1 }, { 17, 24 }, { 32, 24 }, { 32, 0 } };
  for (const auto& corner : outline)
  {
    add(corner[0], corner[1]);
    horizon.Boundary.Append(PointId(horizon.Plane.size() - 1));
  }
  horizon.Boundary.Close();
  // In the cell from 12 to 23 in both directions: two points left of the inlet, three right of it, at equal distance.
  add(14, 13);
  add(14, 14);
  add(18, 13);
  add(18, 14);
  horizon.Height.assign(horizon.Plane.size(), 5.0);
  horizon.Patch.assign(horizon.Plane.size(), 0);
  horizon.Count.assign(horizon.Plane.size(), 1);
  const Reduction result = SimplifyRough(horizon, 12);
  CHECK_EQUAL(result.Source.size(), 8u);
  CHECK(!result.Averaged.back());
  CHECK_EQUAL(result.Source.back(), 7);
  CHECK_EQUAL(Reduce(horizon, result).Count.back(), 4);
}

/// The point nearest to the barycentre, with its own height; and no point is in a place of its own.
void TestNearestPointStandsForTheCell()
{
  BoundedHorizon horizon = FromPicture(Square(9));
  horizon.Count[3 * 9 + 3] = 20; // barycentre at (3.3, 3.3)
  const Reduction result = SimplifyRough(horizon, { 3, RepresentativeKind::NearestPoint });
  CHECK_EQUAL(CheckPoints(horizon, result), std::string());
  CHECK_EQUAL(result.Source.back(), 3 * 9 + 3);
  CHECK_EQUAL(result.Height.back(), 33.0);
}

/// Squares with all points, at the mean height of these.
void TestListedCells()
{
  const Reduction result = SimplifyRough(FromPicture(Square(9)), { 3, RepresentativeKind::Barycentre, true });
  CHECK_EQUAL(result.Cells.size(), 9u);
  const SimplificationCell& middle = result.Cells[4];
  CHECK_EQUAL(middle.Low.X, 3.0);
  CHECK_EQUAL(middle.Low.Y, 3.0);
  CHECK_EQUAL(middle.Low.Z, 44.0);
  CHECK_EQUAL(middle.Size, 3.0);
  CHECK_EQUAL(middle.Points, 9);
  CHECK(middle.Origin.Kind == PointKind::Barycentre);
  CHECK(result.Cells[0].Origin.Kind == PointKind::Boundary);
}

/// A plane stays a plane, whatever cells are cut from it.
void TestPlaneStaysAPlane()
{
  const BoundedHorizon horizon = FromPicture(Square(20));
  for (const int size : { 2, 3, 5, 7 })
  {
    const Reduction result = SimplifyRough(horizon, size);
    for (std::size_t point = 0; point < result.Plane.size(); ++point)
    {
      const double plane = (double(result.Plane[point].X) + 10.0 * double(result.Plane[point].Y)) / SubVoxelsPerColumn;
      CHECK(std::abs(result.Height[point] - plane) < 11.0 / SubVoxelsPerColumn);
    }
  }
}

/// The boundary point of a point's cell and patch that is nearest to it; of equally near ones the first.
PointId NearestOnBoundary(
  const BoundedHorizon& horizon, const std::vector<bool>& onBoundary, PointId point, int cellSize)
{
  const auto place = [&](PointId p) { return horizon.Plane[std::size_t(p)]; };
  const auto group = [&](PointId p)
  {
    const int side = cellSize * horizon.SubVoxelsPerColumn;
    return std::make_tuple(horizon.Patch[std::size_t(p)], place(p).X / side, place(p).Y / side);
  };
  PointId nearest = NoPoint;
  for (PointId other = 0; other < PointId(onBoundary.size()); ++other)
  {
    const bool nearer =
      nearest == NoPoint || SquaredDistance(place(other), place(point)) < SquaredDistance(place(nearest), place(point));
    nearest = onBoundary[std::size_t(other)] && group(other) == group(point) && nearer ? other : nearest;
  }
  return nearest;
}

/// Points that go in a cell with boundary points count for the nearest of these.
std::string CheckTargets(const BoundedHorizon& horizon, const Reduction& result, int cellSize)
{
  const std::vector<bool> onBoundary = FindBoundary(horizon.Boundary, horizon.Plane.size());
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    const PointId source = result.Source[std::size_t(result.Target[point])];
    if (onBoundary[std::size_t(source)] && source != NearestOnBoundary(horizon, onBoundary, PointId(point), cellSize))
    {
      return "point " + std::to_string(point) + " counts for point " + std::to_string(source);
    }
  }
  return {};
}

std::string Wrong(const BoundedHorizon& horizon, const Reduction& result, int cellSize)
{
  const std::string points = CheckPoints(horizon, result);
  const std::string cells = points.empty() ? CheckCells(horizon, result, cellSize, false) : points;
  return cells.empty() ? CheckTargets(horizon, result, cellSize) : cells;
}

void TestRandomPatches()
{
  Patches::Random random(8);
  for (int n = 0; n < 2000; ++n)
  {
    // Cells count from the least corner.
    const Patches::Columns columns =
      MovedToOrigin(Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random));
    const BoundedHorizon full = MakeHorizon(columns, MakeHeights(columns, random));
    const BoundedHorizon horizon = Drop(full, SimplifyBoundary(full, full.Boundary, 3.0 * random.Fraction()));
    const int first = 1 + random.Below(6);
    const Reduction once = SimplifyRough(horizon, { first, RepresentativeKind(n % 5 == 0) });
    CHECK_EQUAL(Wrong(horizon, once, first), std::string());
    const BoundedHorizon again = Reduce(horizon, once);
    const int second = 1 + random.Below(9);
    CHECK_EQUAL(Wrong(again, SimplifyRough(again, second), second), std::string());
  }
}

void TestErrorsAndAbort()
{
  CHECK_THROWS_WITH(SimplifyRough(FromPicture(Square(4)), 0), "cell size 0, expected at least 1 column");
  const BoundedHorizon horizon = FromPicture(Square(80));
  CHECK_EQUAL(
    MonitorChecker::Check(7, [&](const Monitor& monitor) { SimplifyRough(horizon, 3, monitor); }), std::string());
}

void TestEmpty()
{
  CHECK(SimplifyRough(BoundedHorizon(), 3).Source.empty());
}
}

int TestRoughSimplification(int, char*[])
{
  TestBoundaryCellsKeepTheirBoundaryOnly();
  TestInnerCellBecomesItsBarycentre();
  TestColumnsOfOthers();
  TestBarycentreIsWeighted();
  TestCellsStartAtTheBoundingBox();
  TestCellSizeOneChangesNothing();
  TestHugeCellsLeaveTheBoundary();
  TestBarycentreOutside();
  TestNearestPointStandsForTheCell();
  TestListedCells();
  TestPlaneStaysAPlane();
  TestRandomPatches();
  TestErrorsAndAbort();
  TestEmpty();
  return Check::Result();
}
