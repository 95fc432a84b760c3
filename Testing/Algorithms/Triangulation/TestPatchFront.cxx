// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes made in strips beside those of a single front.

#include "Common/Base/Parallel.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/PatchFront.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"

#include <algorithm>
#include <numeric>

using namespace TestHorizons;
using TriangleSets::Canonical;

namespace
{
/// The triangles of all patches together, as if they were one. So fronts are parted by gaps, too.
RawVector<PointId> Grow(const BoundedHorizon& horizon, std::int64_t strips)
{
  const PlaneBox box(horizon.Plane);
  std::vector<PlanePoint> places;
  for (const PlanePoint& place : horizon.Plane)
  {
    places.push_back({ place.X - box.Least.X, place.Y - box.Least.Y });
  }
  std::vector<PointId> names(places.size());
  std::iota(names.begin(), names.end(), 0);
  const SearchGrid grid(places, horizon.Boundary, names);
  const ThirdPointSearch search(grid, SearchStrategy::VoxelTraversal);
  PatchFront front(grid, search, strips);
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to) { front.AddEdge(grid.NumberOf(from), grid.NumberOf(to)); });
  front.Grow(front.MostTriangles() + 1, Monitor());
  const std::size_t count = front.NumberOfTriangles();
  RawVector<PointId> triangles;
  front.MoveTriangles(triangles);
  CHECK_EQUAL(triangles.size(), 3 * count);
  return triangles;
}

void Compare(const BoundedHorizon& horizon)
{
  const auto whole = Canonical(Grow(horizon, 1));
  for (const std::int64_t strips : { 2, 3, 7, 40 })
  {
    const RawVector<PointId> triangles = Grow(horizon, strips);
    CHECK(Canonical(triangles) == whole);
    CHECK_EQUAL(3 * whole.size(), triangles.size());
  }
}

void TestShapes()
{
  Patches::Random random(21);
  for (int shape = 0; shape < int(Patches::Shape::Count); ++shape)
  {
    for (int n = 0; n < 60; ++n)
    {
      const Patches::Columns columns = Patches::Make(Patches::Shape(shape), random);
      const BoundedHorizon full = MakeHorizon(columns, MakeHeights(columns, random));
      Compare(full);
      const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 3.0 * random.Fraction()));
      Compare(straight);
      Compare(Reduce(straight, SimplifyRough(straight, 1 + random.Below(7))));
    }
  }
}

/// Large enough that Triangulate makes strips, with holes, and with an edge across all strips.
BoundedHorizon MakeLarge(Patches::Random& random)
{
  constexpr int size = 260;
  Patches::Columns columns;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const bool hole = (x - 60) * (x - 60) + (y - 130) * (y - 130) < 900 || (x > 200 && x < 230 && y > 20 && y < 240);
      if (!hole && (x == 0 || y == 0 || x == size - 1 || y == size - 1 || random.Chance(0.4)))
      {
        columns.push_back({ x, y });
      }
    }
  }
  const BoundedHorizon full = MakeHorizon(columns, std::vector<double>(columns.size(), 0.0));
  return Drop(full, SimplifyBoundary(full, full.Boundary, 0.4));
}

void TestLarge()
{
  Patches::Random random(22);
  const BoundedHorizon horizon = MakeLarge(random);
  Compare(horizon);
  const int threads = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const Triangulation one = Triangulate(horizon);
  CHECK_EQUAL(MeshChecker::CheckMesh(horizon, one.Triangles), std::string());
  for (const int number : { 2, 3, 8 })
  {
    Detail::NumberOfThreads() = number;
    const Triangulation several = Triangulate(horizon);
    CHECK(several.Triangles == one.Triangles);
    CHECK_EQUAL(several.NonDelaunayEdges, one.NonDelaunayEdges);
  }
  Detail::NumberOfThreads() = threads;
}

/// Loops the wrong way round are found in any strip.
void TestErrors()
{
  BoundedHorizon horizon;
  constexpr int size = 50;
  for (int n = 0; n < 4 * size; ++n)
  {
    const int along = n % size;
    const PlanePoint corners[] = { { along, 0 }, { size, along }, { size - along, size }, { 0, size - along } };
    horizon.Plane.push_back(corners[n / size]);
    horizon.Boundary.Append(n);
  }
  horizon.Boundary.Close();
  for (const std::int64_t strips : { 1, 2, 9 })
  {
    CHECK_THROWS_WITH(Grow(horizon, strips), "no surface to the left of the edge from point ");
  }
}
}

int TestPatchFront(int, char*[])
{
  TestShapes();
  TestLarge();
  TestErrors();
  return Check::Result();
}
