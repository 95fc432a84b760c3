// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells of horizons that are cut.

#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Tools/Check.h"
#include "Tools/ReductionChecker.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

using namespace ReductionChecker;

namespace
{
constexpr double Throw = 15.0;

/// The sides of a cell as rows of letters, the last one that of the least y: without a boundary there is one point for
/// each side.
std::string SidesOf(const LinkCuts& cuts, const PlanePoint& cell, std::int32_t width, std::int32_t height)
{
  BoundedHorizon horizon;
  for (std::int32_t n = 0; n < width * height; ++n)
  {
    horizon.Plane.push_back({ cell.X + n % width, cell.Y + n / width });
  }
  horizon.Height.assign(horizon.Plane.size(), 0.0);
  horizon.Patch.assign(horizon.Plane.size(), 0);
  horizon.Cuts = std::make_shared<const LinkCuts>(cuts);
  const Reduction result = SimplifyRough(horizon, std::max(width, height));
  std::string text;
  for (std::int32_t y = height - 1; y >= 0; --y)
  {
    for (std::int32_t x = 0; x < width; ++x)
    {
      text += char('a' + result.Target[y * width + x]);
    }
    text += y == 0 ? "" : " ";
  }
  return text;
}

/// A crack that ends in a cell is carried on to its border, and one that is all inside at both ends.
void TestTipsAreCarriedOn()
{
  LinkCuts cuts(PlaneBox({ { 0, 0 }, { 9, 9 } }));
  CHECK_EQUAL(SidesOf(cuts, { 0, 0 }, 4, 3), "aaaa aaaa aaaa");
  cuts.CutNorth({ 0, 1 });
  CHECK_EQUAL(SidesOf(cuts, { 0, 0 }, 4, 3), "bbbb aaaa aaaa");
  CHECK_EQUAL(SidesOf(cuts, { 1, 0 }, 4, 3), "aaaa aaaa aaaa");
  cuts.CutEast({ 6, 7 });
  CHECK_EQUAL(SidesOf(cuts, { 5, 5 }, 4, 4), "aabb aabb aabb aabb");
  CHECK_EQUAL(SidesOf(cuts, { 7, 5 }, 4, 4), "aaaa aaaa aaaa aaaa");
  CHECK_EQUAL(SidesOf(cuts, { 5, 6 }, 2, 2), "aa aa"); // the link out of the cell does not count
}

/// It ends at another crack, and turns and rings are sides of their own.
void TestTurnsAndBranches()
{
  LinkCuts cuts(PlaneBox({ { 0, 0 }, { 9, 9 } }));
  cuts.CutNorth({ 0, 1 });
  cuts.CutEast({ 0, 2 });
  CHECK_EQUAL(SidesOf(cuts, { 0, 0 }, 4, 4), "baaa baaa aaaa aaaa");
  for (std::int32_t y = 0; y < 4; ++y)
  {
    cuts.CutEast({ 6, y });
  }
  cuts.CutNorth({ 4, 1 });
  CHECK_EQUAL(SidesOf(cuts, { 4, 0 }, 4, 4), "cccb cccb aaab aaab");
  LinkCuts ring(PlaneBox({ { 0, 0 }, { 9, 9 } }));
  ring.CutEast({ 0, 1 });
  ring.CutEast({ 1, 1 });
  ring.CutNorth({ 1, 0 });
  ring.CutNorth({ 1, 1 });
  CHECK_EQUAL(SidesOf(ring, { 0, 0 }, 3, 3), "aaa aba aaa");
}

/// A step along a crack that ends in a cell of 8: between rows 4 and 5, from column 0 to column 11 of 16.
BoundedHorizon MakeStep()
{
  const Patches::Columns columns = Patches::FromPicture(std::vector<std::string>(12, std::string(16, '#')));
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(column.Y > 4 ? Throw : 0.0);
  }
  LinkCuts cuts{ PlaneBox(columns) };
  for (std::int32_t x = 0; x < 12; ++x)
  {
    cuts.CutNorth({ x, 4 });
  }
  BoundaryOptions options;
  options.Cuts = &cuts;
  BoundedHorizon horizon = MakeHorizon(columns, heights, options);
  horizon.Cuts = std::make_shared<const LinkCuts>(cuts);
  return horizon;
}

/// Heights between the two sides are those of merged points.
std::ptrdiff_t CountBetween(const Reduction& reduction)
{
  return std::count_if(
    reduction.Height.begin(), reduction.Height.end(), [](double height) { return height > 0.0 && height < Throw; });
}

void TestNoPointsAreMergedAcross()
{
  const BoundedHorizon horizon = MakeStep();
  BoundedHorizon withoutCuts = horizon;
  withoutCuts.Cuts = nullptr;
  ElaborateOptions options;
  options.BoundaryDensityThreshold = 0.0;
  options.BoundaryExtentThreshold = 0.0; // cells with boundary points stay whole
  options.CellSize = 16; // one layer
  CHECK_EQUAL(CountBetween(SimplifyElaborate(horizon, options)), 0);
  CHECK(CountBetween(SimplifyElaborate(withoutCuts, options)) > 0);
  for (const RepresentativeKind kind : { RepresentativeKind::Barycentre, RepresentativeKind::NearestPoint })
  {
    const Reduction rough = SimplifyRough(horizon, CellOptions(8, kind));
    CHECK_EQUAL(CountBetween(rough), 0);
    CHECK_EQUAL(CheckPoints(horizon, rough), std::string());
    // Points that go count for others of their side.
    for (std::size_t point = 0; point < rough.Target.size(); ++point)
    {
      CHECK_EQUAL(rough.Height[rough.Target[point]], horizon.Height[point]);
    }
  }
}

/// A side around a corner has its barycentre beyond both cutoffs, in the patch all the same: another point represents
/// it.
void TestBarycentreBeyondCrack()
{
  constexpr std::int32_t size = 20; // of the cell; the crack ends outside
  const Patches::Columns columns = Patches::FromPicture(std::vector<std::string>(28, std::string(28, '#')));
  const auto isWithin = [](const PlanePoint& column) { return column.X >= 4 && column.Y >= 4; };
  LinkCuts cuts{ PlaneBox(columns) };
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(isWithin(column) ? Throw : 0.0);
    if (column.X < size + 3 && !isWithin(column) && isWithin({ column.X, column.Y + 1 }))
    {
      cuts.CutNorth(column);
    }
    if (column.Y < size + 3 && !isWithin(column) && isWithin({ column.X + 1, column.Y }))
    {
      cuts.CutEast(column);
    }
  }
  BoundaryOptions boundary;
  boundary.Cuts = &cuts;
  BoundedHorizon horizon = MakeHorizon(columns, heights, boundary);
  horizon.Cuts = std::make_shared<const LinkCuts>(cuts);
  ElaborateOptions options(size);
  options.BoundaryDensityThreshold = 0.0;
  const Reduction result = SimplifyElaborate(horizon, options);
  for (std::size_t point = 0; point < result.Plane.size(); ++point)
  {
    const PlanePoint column{ result.Plane[point].X / SubVoxelsPerColumn, result.Plane[point].Y / SubVoxelsPerColumn };
    if (std::max(column.X, column.Y) < size)
    {
      CHECK_EQUAL(result.Height[point], isWithin(column) ? Throw : 0.0);
    }
  }
}

void TestTooManySides()
{
  BoundedHorizon horizon = MakeStep();
  horizon.Patch.assign(horizon.Patch.size(), std::numeric_limits<std::int32_t>::max());
  CHECK_THROWS_WITH(SimplifyRough(horizon, 8),
    "patch numbers up to 2147483647, expected lower ones: with the sides of cut cells there are too many");
}
}

int TestCellSides(int, char*[])
{
  TestTipsAreCarriedOn();
  TestTurnsAndBranches();
  TestNoPointsAreMergedAcross();
  TestBarycentreBeyondCrack();
  TestTooManySides();
  return Check::Result();
}
