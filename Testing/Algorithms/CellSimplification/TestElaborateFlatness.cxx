// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The elaborate simplification: how flat cells are, and those that are cut as they are not flat enough.

#include "ElaborateFixtures.h"
#include "Filters/Algorithms/CellSimplification/Flatness.h"
#include "Tools/Check.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

using namespace ElaborateFixtures;

namespace
{
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

/// A step through the middle of the middle cell: its halves are level. Flat enough as a whole for a third at most.
void TestCurvedInnerCellIsHalved()
{
  const BoundedHorizon horizon = Square(24, [](int x, int) { return x < 12 ? 0.0 : 1.0; });
  const Reduction cut = SimplifyElaborate(horizon, ElaborateOptions(8, 0.0));
  CHECK((CountLevels(cut, 2, PointKind::Barycentre) == Levels{ { 1, 4 } }));
  const Reduction whole = SimplifyElaborate(horizon, ElaborateOptions(8, 1.0 / 3.0));
  CHECK((CountLevels(whole, 2, PointKind::Barycentre) == Levels{ { 0, 1 } }));
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

/// Boundary points and the representative of the others of their cell have one flatness, that of all its points;
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
}

int TestElaborateFlatness(int, char*[])
{
  TestCurvedInnerCellIsHalved();
  TestFlatnessZeroGoesDownToColumns();
  TestFlatnessOfCells();
  TestFlatnessIsThatOfTheCell();
  TestFlatness();
  return Check::Result();
}
