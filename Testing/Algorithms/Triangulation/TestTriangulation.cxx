// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/MonitorChecker.h"
#include "Tools/TestHorizons.h"
#include "Tools/TriangleSets.h"

#include <algorithm>
#include <set>

using namespace TestHorizons;
using TriangleSets::Canonical;

namespace
{
BoundedHorizon FromPicture(const std::vector<std::string>& picture)
{
  return MakeLevelHorizon(Patches::FromPicture(picture));
}

/// A horizon of one patch with one loop over its first points.
BoundedHorizon FromPolygon(const std::vector<PlanePoint>& places, int loopLength)
{
  BoundedHorizon horizon;
  horizon.Plane = places;
  horizon.Height.assign(places.size(), 0.0);
  horizon.Patch.assign(places.size(), 0);
  horizon.Count.assign(places.size(), 1);
  for (int point = 0; point < loopLength; ++point)
  {
    horizon.Boundary.Append(point);
  }
  horizon.Boundary.Close();
  return horizon;
}

/// What is wrong with the mesh of a horizon; with that of the other strategy too, which must be the same.
std::string Mesh(const BoundedHorizon& horizon)
{
  const RawVector<PointId> triangles = Triangulate(horizon).Triangles;
  if (Canonical(triangles) != Canonical(Triangulate(horizon, { SearchStrategy::Compactness }).Triangles))
  {
    return "the strategies differ";
  }
  return MeshChecker::CheckMesh(horizon, triangles);
}

void TestSmallMeshes()
{
  CHECK(Triangulate(FromPicture({ "#" })).Triangles.empty());
  CHECK(Triangulate(FromPicture({ "####" })).Triangles.empty());
  CHECK_EQUAL(Triangulate(FromPicture({ "##", "##" })).Triangles.size(), 6u);
  CHECK_EQUAL(Triangulate(FromPicture({ "##", "#." })).Triangles.size(), 3u);
  // Four triangles around the middle one, eight when its square is full, two fewer when it is missing.
  CHECK_EQUAL(Triangulate(FromPicture({ ".#.", "###", ".#." })).Triangles.size(), 12u);
  CHECK_EQUAL(Triangulate(FromPicture({ "###", "###", "###" })).Triangles.size(), 24u);
  CHECK_EQUAL(Triangulate(FromPicture({ "###", "#.#", "###" })).Triangles.size(), 18u);
}

/// By hand: of the quadrangle's two diagonals the one that leaves the circles empty.
void TestDelaunayDiagonal()
{
  const RawVector<PointId> triangles =
    Triangulate(FromPolygon({ { 0, 0 }, { 5, 2 }, { 10, 0 }, { 5, -2 } }, 4)).Triangles;
  CHECK_EQUAL(triangles.size(), 6u);
  // Both triangles have the short diagonal from point 1 to point 3.
  CHECK_EQUAL(std::count(triangles.begin(), triangles.end(), 1), 2);
  CHECK_EQUAL(std::count(triangles.begin(), triangles.end(), 3), 2);
}

/// An edge that is not Delaunay, but a boundary: a deep notch whose tip lies in the circles around it.
void TestConstrainedEdges()
{
  const BoundedHorizon notch =
    FromPolygon({ { 0, 0 }, { 0, 40 }, { 19, 40 }, { 20, 3 }, { 21, 40 }, { 40, 40 }, { 40, 0 }, { 20, 1 } }, 7);
  CHECK_EQUAL(Mesh(notch), std::string());
}

/// No point stands at the least corner of the box, to the left of all edges here: what a search finds there does not
/// count.
void TestEmptyCorner()
{
  CHECK_EQUAL(Mesh(FromPolygon({ { 0, 14336 }, { 2048, 15360 }, { 3072, 1024 }, { 1024, 0 }, { 1536, 6144 },
                                 { 1536, 8704 }, { 1024, 10240 } },
                4)),
    std::string());
}

void TestRandomPatches()
{
  Patches::Random random(4);
  for (int shape = 0; shape < int(Patches::Shape::Count); ++shape)
  {
    for (int n = 0; n < 200; ++n)
    {
      const Patches::Columns columns = Patches::Make(Patches::Shape(shape), random);
      const BoundedHorizon full = MakeHorizon(columns, MakeHeights(columns, random));
      CHECK_EQUAL(Mesh(full), std::string());
      const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 3.0 * random.Fraction()));
      CHECK_EQUAL(Mesh(straight), std::string());
      const BoundedHorizon rough = Reduce(straight, SimplifyRough(straight, 1 + random.Below(7)));
      CHECK_EQUAL(Mesh(rough), std::string());
      CHECK_EQUAL(Mesh(Reduce(rough, SimplifyRough(rough, 1 + random.Below(9)))), std::string());
    }
  }
}

/// Points at random inside a square frame, many of them nearly on one line or on one circle.
void TestHardPoints()
{
  Patches::Random random(5);
  for (int n = 0; n < 300; ++n)
  {
    const std::int32_t size = 1 << (4 + random.Below(25));
    std::vector<PlanePoint> places = { { 0, 0 }, { 0, size }, { size, size }, { size, 0 } };
    std::set<PlanePoint> taken(places.begin(), places.end());
    for (int point = 0; point < 60; ++point)
    {
      const double angle = 6.2831853 * random.Fraction();
      const double along = 0.1 + 0.8 * random.Fraction();
      const PlanePoint place = n % 3 == 0
        ? PlanePoint{ std::int32_t(size * along), std::int32_t(size * along) + random.Below(2) }
        : (n % 3 == 1 ? PlanePoint{ std::int32_t(size * (0.5 + 0.4 * std::cos(angle))),
                          std::int32_t(size * (0.5 + 0.4 * std::sin(angle))) }
                      : PlanePoint{ 1 + random.Below(size - 1), 1 + random.Below(size - 1) });
      if (place.X > 0 && place.Y > 0 && place.X < size && place.Y < size && taken.insert(place).second)
      {
        places.push_back(place);
      }
    }
    CHECK_EQUAL(Mesh(FromPolygon(places, 4)), std::string());
  }
}

void TestOrderOfPointsIsNoMatter()
{
  Patches::Random random(6);
  for (int n = 0; n < 100; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape::Blob, random);
    const std::size_t size = columns.size();
    const auto turnedBack = [size](PointId point) { return PointId(size) - 1 - point; };
    const Patches::Columns turned(columns.rbegin(), columns.rend());
    const std::vector<double> heights(size, 0.0);
    CHECK(Canonical(Triangulate(MakeHorizon(columns, heights)).Triangles) ==
      Canonical(Triangulate(MakeHorizon(turned, heights)).Triangles, turnedBack));
  }
}

/// Whether some circle through the ends of an edge holds no point, by trying the circle of each point to the left of
/// it. With `ties` a circle with a point on it counts as empty.
bool IsDelaunay(const std::vector<PlanePoint>& places, const PlanePoint& a, const PlanePoint& b, bool ties)
{
  const auto isEmpty = [&](const PlanePoint& third)
  {
    return std::none_of(places.begin(), places.end(),
      [&](const PlanePoint& p)
      {
        const int side = ExactPlane::SideOfCircle(a, b, third, p);
        return !(p == a) && !(p == b) && !(p == third) && (ties ? side > 0 : side >= 0);
      });
  };
  return std::any_of(places.begin(), places.end(),
    [&](const PlanePoint& third) { return SignedArea(a, b, third) > 0 && isEmpty(third); });
}

/// Points on one circle may or may not count, as ties are settled; all others must be counted as by hand.
void TestNonDelaunayEdgesAreCounted()
{
  Patches::Random random(11);
  std::size_t found = 0;
  for (int n = 0; n < 300; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon full = MakeHorizon(columns, MakeHeights(columns, random));
    const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 5.0));
    const BoundedHorizon horizon = n % 2 == 0 ? straight : Reduce(straight, SimplifyRough(straight, 3));
    std::set<std::pair<PointId, PointId>> edges;
    horizon.Boundary.ForEachEdge(
      [&edges](PointId from, PointId to)
      {
        if (edges.erase({ from, to }) == 0)
        {
          edges.insert({ to, from });
        }
      });
    std::size_t least = 0;
    std::size_t most = 0;
    for (const auto& [from, to] : edges)
    {
      std::vector<PlanePoint> patch;
      for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
      {
        if (horizon.Patch[point] == horizon.Patch[from])
        {
          patch.push_back(horizon.Plane[point]);
        }
      }
      least += IsDelaunay(patch, horizon.Plane[from], horizon.Plane[to], true) ? 0 : 1;
      most += IsDelaunay(patch, horizon.Plane[from], horizon.Plane[to], false) ? 0 : 1;
    }
    const Triangulation mesh = Triangulate(horizon);
    CHECK_EQUAL(mesh.BoundaryEdges, edges.size());
    CHECK(least <= mesh.NonDelaunayEdges && mesh.NonDelaunayEdges <= most);
    found += mesh.NonDelaunayEdges;
  }
  CHECK(found > 0);
}

/// Stopped after so many triangles, the mesh is a part of the whole, and the walk leads to the last third point.
void TestStopsAndTraces()
{
  const BoundedHorizon horizon = FromPicture({ "######", "######", "##..##", "######", "######" });
  const auto whole = Canonical(Triangulate(horizon).Triangles);
  for (const SearchStrategy strategy : { SearchStrategy::VoxelTraversal, SearchStrategy::Compactness })
  {
    for (std::size_t most = 1; most <= whole.size(); ++most)
    {
      const Triangulation part = Triangulate(horizon, { strategy, most });
      CHECK_EQUAL(part.Triangles.size(), 3 * most);
      const auto triangles = Canonical(part.Triangles);
      CHECK(std::includes(whole.begin(), whole.end(), triangles.begin(), triangles.end()));
      const PlanePoint third = horizon.Plane[part.Triangles.back()];
      CHECK(std::any_of(part.Walk.begin(), part.Walk.end(),
        [&third](const TracedCell& cell)
        {
          return cell.Least.X <= third.X && third.X < cell.Greatest.X && cell.Least.Y <= third.Y &&
            third.Y < cell.Greatest.Y;
        }));
      CHECK_EQUAL(part.Walk.front().Dilatation, strategy == SearchStrategy::VoxelTraversal ? 0 : -1);
    }
    CHECK(Canonical(Triangulate(horizon, { strategy, 10000 }).Triangles) == whole);
  }
  CHECK(Triangulate(horizon).Walk.empty());
}

void TestErrors()
{
  const std::vector<PlanePoint> square = { { 0, 0 }, { 0, 8 }, { 8, 8 }, { 8, 0 } };
  std::vector<PlanePoint> places = square;
  places.push_back({ 3, 3 });
  places.push_back({ 3, 3 });
  CHECK_THROWS_WITH(Triangulate(FromPolygon(places, 4)), "points 4 and 5 in one place in plan");
  places = square;
  places.push_back({ 0, 3 });
  CHECK_THROWS_WITH(Triangulate(FromPolygon(places, 4)), "point 4 lies on boundary edge 0 - 1");
  places = square;
  places.push_back({ 9, 3 });
  CHECK_THROWS_WITH(Triangulate(FromPolygon(places, 4)), "point 4 lies outside the boundary of its patch");
  CHECK_THROWS_WITH(Triangulate(FromPolygon({ { 0, 0 }, { 8, 8 }, { 0, 8 }, { 8, 0 } }, 4)),
    "boundary edge 2 - 3 crosses boundary edge 0 - 1");
  // The same square the wrong way round.
  CHECK_THROWS_WITH(
    Triangulate(FromPolygon({ { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 } }, 4)), "no surface to the left of the edge");
  BoundedHorizon horizon = FromPolygon(square, 4);
  horizon.Patch[2] = 1;
  CHECK_THROWS_WITH(Triangulate(horizon), "boundary loop 0 runs from patch 0 to patch 1 at point 2");
  horizon.Patch[2] = -5;
  CHECK_THROWS_WITH(Triangulate(horizon), "patch numbers from -5 to 0, expected numbers from 0");
}

/// Every other column, so that all triangles have to be searched for: in one strip, and in many.
void TestMonitor()
{
  for (const std::size_t size : { 80, 300 })
  {
    std::vector<std::string> picture(size);
    for (std::size_t row = 0; row < picture.size(); ++row)
    {
      for (std::size_t n = 0; n < size / 2; ++n)
      {
        picture[row] += row % 2 == 0 ? "#." : ".#";
      }
    }
    const BoundedHorizon horizon = FromPicture(picture);
    const int leastCalls = size < 100 ? 3 : 6;
    CHECK_EQUAL(MonitorChecker::Check(
                  leastCalls, [&](const Monitor& monitor) { Triangulate(horizon, TriangulationOptions(), monitor); }),
      std::string());
  }
}

void TestEmpty()
{
  CHECK_EQUAL(Triangulate(BoundedHorizon()).Triangles.size(), 0u);
}
}

int TestTriangulation(int, char*[])
{
  TestSmallMeshes();
  TestDelaunayDiagonal();
  TestConstrainedEdges();
  TestEmptyCorner();
  TestRandomPatches();
  TestHardPoints();
  TestOrderOfPointsIsNoMatter();
  TestNonDelaunayEdgesAreCounted();
  TestStopsAndTraces();
  TestErrors();
  TestMonitor();
  TestEmpty();
  return Check::Result();
}
