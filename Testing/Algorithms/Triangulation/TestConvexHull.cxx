// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/Patches.h"

#include <algorithm>

using namespace SeismicHorizons;

namespace
{
std::vector<PointId> Hull(const std::vector<PlanePoint>& places)
{
  const Loops hull = FindConvexHull(places);
  CHECK_EQUAL(hull.Size(), 1u);
  return { hull.begin(0), hull.end(0) };
}

using Ids = std::vector<PointId>;

void TestSmallHulls()
{
  CHECK(Hull({ { 3, 4 } }) == Ids({ 0 }));
  CHECK(Hull({ { 3, 4 }, { 1, 1 } }) == Ids({ 1, 0 }));
  CHECK(Hull({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, 1 } }) == Ids({ 0, 3, 2, 1 }));
  // A point on an edge of the hull is a corner of the loop; points on one line are walked there and back.
  CHECK(Hull({ { 0, 0 }, { 4, 0 }, { 0, 4 }, { 2, 2 } }) == Ids({ 0, 2, 3, 1 }));
  CHECK(Hull({ { 0, 0 }, { 4, 4 }, { 2, 2 } }) == Ids({ 0, 2, 1, 2 }));
  CHECK(Hull({ { 0, 4 }, { 0, 0 }, { 0, 2 } }) == Ids({ 1, 2, 0, 2 }));
}

/// Meshed, the hull of any points is their Delaunay triangulation: no edge of it is there only because it was asked
/// for.
void TestRandomPoints()
{
  Patches::Random random(10);
  for (int n = 0; n < 600; ++n)
  {
    BoundedHorizon horizon;
    horizon.Plane = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    horizon.Patch.assign(horizon.Plane.size(), 0);
    horizon.Boundary = FindConvexHull(horizon.Plane);
    const Triangulation mesh = Triangulate(horizon);
    CHECK_EQUAL(MeshChecker::CheckMesh(horizon, mesh.Triangles), std::string());
    CHECK_EQUAL(mesh.NonDelaunayEdges, 0u);
    for (const PlanePoint& place : horizon.Plane)
    {
      CHECK(horizon.Plane.size() == 1 || ExactPlane::Locate(horizon.Plane, horizon.Boundary, place) >= 0);
    }
    const Ids hull(horizon.Boundary.begin(0), horizon.Boundary.end(0));
    CHECK(horizon.Plane[hull.front()] == *std::min_element(horizon.Plane.begin(), horizon.Plane.end()));
    for (std::size_t corner = 0; corner < hull.size(); ++corner)
    {
      const auto at = [&](std::size_t number) { return horizon.Plane[hull[number % hull.size()]]; };
      const PlanePoint a = at(corner);
      const PlanePoint b = at(corner + 1);
      const PlanePoint c = at(corner + 2);
      const double turn = double(b.X - a.X) * (c.Y - b.Y) - double(b.Y - a.Y) * (c.X - b.X);
      CHECK(turn <= 0.0);
    }
  }
}
}

int TestConvexHull(int, char*[])
{
  TestSmallHulls();
  TestRandomPoints();
  return Check::Result();
}
