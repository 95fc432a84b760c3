// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"
#include "Tools/Check.h"

#include <cmath>
#include <limits>

using namespace SeismicHorizons;

namespace
{
/// A survey turned by 30 degrees, far from the origin of its map projection, with a step of 4 ms downwards.
Eigen::Matrix4d RotatedSurvey()
{
  const double c = 12.5 * std::cos(0.5236);
  const double s = 12.5 * std::sin(0.5236);
  Eigen::Matrix4d map = Eigen::Matrix4d::Identity();
  map << c, -2.0 * s, 0, 604321.25, s, 2.0 * c, 0, 6079543.5, 0, 0, -4, 100, 0, 0, 0, 1;
  return map;
}

void TestRoundTrip()
{
  const Lattice lattice({ 1300, 950, 462 }, RotatedSurvey());
  for (int i = 0; i < 1300; i += 13)
  {
    const Eigen::Vector3d place(i, 949 - i / 2, 0.25 * i);
    const Eigen::Vector3d back = lattice.ToLattice(lattice.ToWorld(place));
    CHECK((back - place).norm() < 1e-6);
    const PlanePoint subVoxels = lattice.ToSubVoxels(back, 0);
    CHECK_EQUAL(subVoxels.X, i * lattice.SubVoxelsPerColumn());
    CHECK_EQUAL(lattice.ToLatticeUnits(subVoxels.Y), 949 - i / 2);
  }
  CHECK(lattice.KeepsOrientation());
}

void TestOrientation()
{
  Eigen::Matrix4d mirrored = Eigen::Matrix4d::Identity();
  mirrored(1, 1) = -1.0;
  CHECK(!Lattice({ 2, 2, 2 }, mirrored).KeepsOrientation());
  mirrored = Eigen::Matrix4d::Identity();
  mirrored(2, 2) = -4.0; // down is no mirror in plan
  CHECK(Lattice({ 2, 2, 2 }, mirrored).KeepsOrientation());
}

void TestUniformScale()
{
  const double c = 12.5 * std::cos(0.3);
  const double s = 12.5 * std::sin(0.3);
  Eigen::Matrix4d map = Eigen::Matrix4d::Identity();
  map << c, -s, 0, 604321.25, s, c, 0, 6079543.5, 0, 0, -12.5, 100, 0, 0, 0, 1;
  CHECK(std::abs(Lattice({ 2, 2, 2 }, map).UniformScale() - 12.5) < 1e-12);
  map(2, 2) = -12.4999;
  CHECK_EQUAL(Lattice({ 2, 2, 2 }, map).UniformScale(), 0.0);
  CHECK_EQUAL(Lattice({ 2, 2, 2 }, RotatedSurvey()).UniformScale(), 0.0);
  map = Eigen::Matrix4d::Identity();
  map(0, 1) = 0.5; // columns that are not square
  CHECK_EQUAL(Lattice({ 2, 2, 2 }, map).UniformScale(), 0.0);
}

void TestSubVoxelsFit()
{
  for (const int size : { 1, 7, 481, 9000, 1 << 20, (1 << 28) - 1 })
  {
    const Lattice lattice({ size, size, 1 }, Eigen::Matrix4d::Identity());
    const PlanePoint last = lattice.ToSubVoxels({ size - 0.5, size - 0.5, 0.0 }, 0);
    CHECK(last.X > 0 && last.X < (1 << 29));
  }
}

/// To the nearest sub-voxel, halves away from 0; half a column outside the lattice is still on it.
void TestRounding()
{
  const Lattice lattice({ 5, 4, 3 }, Eigen::Matrix4d::Identity());
  const double scale = lattice.SubVoxelsPerColumn();
  for (const double place : { -100.0, -1.5, -1.4, -0.5, -0.4, 0.0, 0.3, 0.5, 0.6, 1.5, 1234.4, 1234.5, 1234.6 })
  {
    const PlanePoint rounded = lattice.ToSubVoxels({ place / scale, (place + 7.0) / scale, 0.0 }, 0);
    CHECK_EQUAL(rounded.X, std::lround(place));
    CHECK_EQUAL(rounded.Y, std::lround(place + 7.0));
  }
  CHECK(lattice.ToSubVoxels({ -0.5, -0.5, 0.0 }, 0) == (PlanePoint{ -(1 << 19), -(1 << 19) }));
  CHECK(lattice.ToSubVoxels({ 4.5, 3.5, 0.0 }, 0) == (PlanePoint{ 9 << 19, 7 << 19 }));
  for (const Eigen::Vector3d& outside : { Eigen::Vector3d(-0.51, 0, 0), Eigen::Vector3d(4.51, 0, 0),
         Eigen::Vector3d(0, -0.51, 0), Eigen::Vector3d(0, 3.51, 0) })
  {
    CHECK_THROWS_WITH(lattice.ToSubVoxels(outside, 0), "expected a place on the lattice");
  }
}

void TestErrors()
{
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  CHECK_THROWS_WITH(Lattice({ 0, 2, 2 }, identity), "lattice of 0 x 2 x 2 cells, expected at least 1");
  CHECK_THROWS_WITH(Lattice({ 1 << 28, 2, 2 }, identity), "less than 2^28 columns a side");
  CHECK_THROWS_WITH(Lattice({ 2, std::numeric_limits<int>::max(), 2 }, identity), "less than 2^28 columns a side");
  Eigen::Matrix4d map = identity;
  map(0, 3) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Lattice({ 2, 2, 2 }, map), "matrix that is not affine");
  map = identity;
  map(3, 0) = 0.5;
  CHECK_THROWS_WITH(Lattice({ 2, 2, 2 }, map), "matrix that is not affine");
  map = identity;
  map(0, 2) = 0.1;
  CHECK_THROWS_WITH(Lattice({ 2, 2, 2 }, map), "matrix that tilts the columns");
  map = identity;
  map(1, 1) = 0.0;
  CHECK_THROWS_WITH(Lattice({ 2, 2, 2 }, map), "matrix that cannot be inverted");
  map = identity;
  map(2, 2) = 0.0;
  CHECK_THROWS_WITH(Lattice({ 2, 2, 2 }, map), "matrix that cannot be inverted");
  const Lattice lattice({ 5, 4, 3 }, identity);
  CHECK_THROWS_WITH(lattice.ToSubVoxels({ 5.0, 1.0, 0.0 }, 17),
    "point 17 at column (5, 1), height 0, expected a place on the lattice of 5 x 4 columns");
  CHECK_THROWS_WITH(lattice.ToSubVoxels({ 1.0, 1.0, std::numeric_limits<double>::infinity() }, 3), "point 3");
  CHECK_THROWS_WITH(lattice.ToSubVoxels({ 1.0, 1.0, std::numeric_limits<double>::quiet_NaN() }, 3), "point 3");
  CHECK_THROWS_WITH(lattice.ToSubVoxels({ 1.0, 1.0, -1e300 }, 3),
    "height -1e+300, expected a place on the lattice of 5 x 4 columns, at "
    "most 2^50 vertical indices up or down");
  CHECK_EQUAL(lattice.ToSubVoxels({ 1.0, 1.0, LargestHeight }, 3).X, 1 << 20);
}
}

int TestLattice(int, char*[])
{
  TestRoundTrip();
  TestOrientation();
  TestUniformScale();
  TestSubVoxelsFit();
  TestRounding();
  TestErrors();
  return Check::Result();
}
