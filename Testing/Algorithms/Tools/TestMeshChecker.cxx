// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker of meshes must find each kind of damage.

#include "Check.h"
#include "Common/Horizon/MeshChecker.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "TestHorizons.h"

#include <algorithm>

using namespace TestHorizons;

namespace
{
struct Damaged
{
  BoundedHorizon Horizon;
  RawVector<PointId> Triangles;

  std::string Check() const { return MeshChecker::CheckMesh(this->Horizon, this->Triangles); }
};

Damaged Sound()
{
  const Patches::Columns columns = Patches::FromPicture({ "#####", "#####", "###..", "###.." });
  Damaged mesh;
  mesh.Horizon = MakeLevelHorizon(columns);
  mesh.Triangles = Triangulate(mesh.Horizon).Triangles;
  return mesh;
}

void TestDamagedMeshes()
{
  CHECK_EQUAL(Sound().Check(), std::string());

  Damaged mesh = Sound();
  mesh.Triangles.resize(mesh.Triangles.size() - 3);
  CHECK(mesh.Check() != "");

  mesh = Sound();
  std::swap(mesh.Triangles[0], mesh.Triangles[1]);
  CHECK_EQUAL(mesh.Check().find("triangle facing down"), 0u);

  mesh = Sound();
  mesh.Triangles.insert(mesh.Triangles.end(), mesh.Triangles.begin(), mesh.Triangles.begin() + 3);
  CHECK_EQUAL(mesh.Check().find("two triangles left of"), 0u);

  mesh = Sound();
  mesh.Horizon.Plane.push_back({ SubVoxelsPerColumn / 2, SubVoxelsPerColumn / 3 });
  mesh.Horizon.Patch.push_back(0);
  CHECK_EQUAL(mesh.Check().find("unused point"), 0u);

  mesh = Sound();
  mesh.Triangles.push_back(0);
  CHECK_EQUAL(mesh.Check(), "52 corners, expected three of each triangle");

  mesh = Sound();
  mesh.Triangles[4] = PointId(mesh.Horizon.Plane.size());
  CHECK_EQUAL(mesh.Check().find("no point of the plane in triangle 1 of points "), 0u);
}

/// A square with a triangle on its upper side, as the boundary has it.
Damaged SquareAndTriangle(const RawVector<PointId>& triangles)
{
  Damaged mesh;
  mesh.Horizon.Plane = { { 0, 0 }, { 0, 2 }, { 3, 3 }, { 2, 2 }, { 2, 0 } };
  mesh.Horizon.Patch.assign(5, 0);
  for (PointId point = 0; point < 5; ++point)
  {
    mesh.Horizon.Boundary.Append(point);
  }
  mesh.Horizon.Boundary.Close();
  mesh.Triangles = triangles;
  return mesh;
}

/// Meshes of the right area, with all points, that do not fit their boundary.
void TestWrongBoundary()
{
  Damaged mesh = SquareAndTriangle({ 0, 4, 3, 0, 3, 1, 1, 3, 2 });
  CHECK_EQUAL(mesh.Check(), std::string());
  // The triangle as large on the right side of the square.
  CHECK_EQUAL(SquareAndTriangle({ 0, 4, 3, 0, 3, 1, 4, 2, 3 }).Check(),
    "boundary and mesh differ at 2 - 3, triangle 2 of points 4, 2, 3");
  // A loop along a line encloses nothing, and has no triangles.
  for (const std::int32_t x : { 10, 11, 12 })
  {
    mesh.Horizon.Boundary.Append(PointId(mesh.Horizon.Plane.size()));
    mesh.Horizon.Plane.push_back({ x, 0 });
    mesh.Horizon.Patch.push_back(0);
  }
  mesh.Horizon.Boundary.Close();
  CHECK_EQUAL(mesh.Check(), "no triangle at boundary 5 - 7");
}

/// What a build that checks all meshes ends with.
void TestRequire()
{
  Damaged mesh = SquareAndTriangle({ 0, 4, 3, 0, 3, 1, 1, 3, 2 });
  MeshChecker::Require("A method", mesh.Horizon.Plane, mesh.Horizon.Boundary, mesh.Triangles);
  std::swap(mesh.Triangles[3], mesh.Triangles[4]);
  CHECK_THROWS_WITH(MeshChecker::Require("A method", mesh.Horizon.Plane, mesh.Horizon.Boundary, mesh.Triangles),
    "A method made a wrong mesh: triangle facing down at 3 - 0, triangle 1 of points 3, 0, 1");
}

/// In such a build, methods do check: here one that takes triangles off a mesh is given one of them twice.
void TestMethodsCheck()
{
  BoundedHorizon hull;
  hull.Plane = { { 0, 0 }, { 0, 2 }, { 1, 1 }, { 9, 2 }, { 9, 0 } };
  hull.Patch.assign(5, 0);
  hull.Boundary = FindConvexHull(hull.Plane);
  Triangulation mesh = Triangulate(hull);
  mesh.Triangles.insert(mesh.Triangles.end(), mesh.Triangles.begin(), mesh.Triangles.begin() + 3);
  const auto takeOff = [&]() { RemoveOutsideTriangles(hull, mesh, { 180.0, 100.0 }); };
  if (MeshChecker::IsOn)
  {
    CHECK_THROWS_WITH(takeOff(), "RemoveOutsideTriangles made a wrong mesh: two triangles left of ");
  }
  else
  {
    takeOff();
  }
}

/// A point that moves into the circle of an edge leaves a mesh that has no overlap and no gap, but is not Delaunay.
void TestNotDelaunay()
{
  Damaged mesh;
  mesh.Horizon = MakeHorizon(Patches::FromPicture({ "##", "##" }), { 0.0, 0.0, 0.0, 0.0 });
  mesh.Triangles = Triangulate(mesh.Horizon).Triangles;
  CHECK_EQUAL(mesh.Check(), std::string());
  // The ends of the diagonal stay; one of the other two points moves inwards or outwards.
  const auto count = [&mesh](PointId point) { return std::count(mesh.Triangles.begin(), mesh.Triangles.end(), point); };
  const PointId moved = count(0) == 1 ? 3 : 2;
  const PlanePoint corner = mesh.Horizon.Plane[moved];
  const int step = moved == 3 ? 100 : -100;
  mesh.Horizon.Plane[moved] = { corner.X + step, corner.Y + 100 };
  CHECK_EQUAL(mesh.Check(), std::string());
  mesh.Horizon.Plane[moved] = { corner.X - step, corner.Y - 100 };
  CHECK_EQUAL(mesh.Check().find("not Delaunay"), 0u);
}
}

int TestMeshChecker(int, char*[])
{
  TestDamagedMeshes();
  TestNotDelaunay();
  TestWrongBoundary();
  TestRequire();
  TestMethodsCheck();
  return Check::Result();
}
