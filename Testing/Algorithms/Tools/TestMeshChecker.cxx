// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A checker that finds nothing is worth nothing: each kind of damage must be seen.

#include "Check.h"
#include "MeshChecker.h"
#include "TestHorizons.h"
#include "Triangulation/Triangulation.h"

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
  mesh.Horizon = MakeHorizon(columns, std::vector<double>(columns.size(), 0.0));
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
}

/// A point that moves across an edge's circle leaves a mesh that is sound but not Delaunay.
void TestNotDelaunay()
{
  Damaged mesh;
  mesh.Horizon = MakeHorizon(Patches::FromPicture({ "##", "##" }), { 0.0, 0.0, 0.0, 0.0 });
  mesh.Triangles = Triangulate(mesh.Horizon).Triangles;
  CHECK_EQUAL(mesh.Check(), std::string());
  // The ends of the diagonal stay; one of the other two points moves inwards or outwards.
  const auto count = [&mesh](PointId point) { return std::count(mesh.Triangles.begin(), mesh.Triangles.end(), point); };
  const PointId moved = count(0) == 1 ? 3 : 2;
  const PlanePoint corner = mesh.Horizon.Plane[std::size_t(moved)];
  const int step = moved == 3 ? 100 : -100;
  mesh.Horizon.Plane[std::size_t(moved)] = { corner.X + step, corner.Y + 100 };
  CHECK_EQUAL(mesh.Check(), std::string());
  mesh.Horizon.Plane[std::size_t(moved)] = { corner.X - step, corner.Y - 100 };
  CHECK_EQUAL(mesh.Check().find("not Delaunay"), 0u);
}

void TestDamagedBoundaries()
{
  const Patches::Columns columns = Patches::FromPicture({ "####", "#..#", "####", "...#" });
  const ExteriorBoundary sound = FindExteriorBoundary(columns);
  CHECK_EQUAL(MeshChecker::CheckExteriorBoundary(columns, sound), std::string());

  ExteriorBoundary damaged = sound;
  damaged.Patch[3] = 1;
  CHECK(MeshChecker::CheckExteriorBoundary(columns, damaged) != "");

  const auto withLoop = [&](std::vector<PointId> points)
  {
    ExteriorBoundary result = sound;
    result.Boundary = Loops();
    std::for_each(points.begin(), points.end(), [&](PointId point) { result.Boundary.Append(point); });
    result.Boundary.Close();
    return MeshChecker::CheckExteriorBoundary(columns, result);
  };
  std::vector<PointId> loop(sound.Boundary.begin(0), sound.Boundary.end(0));
  CHECK_EQUAL(withLoop(loop), std::string());
  std::reverse(loop.begin() + 1, loop.end());
  CHECK_EQUAL(withLoop(loop), "direction of a loop");
  std::reverse(loop.begin() + 1, loop.end());
  std::rotate(loop.begin(), loop.begin() + 2, loop.end());
  CHECK_EQUAL(withLoop(loop), "first point of a loop");
  std::rotate(loop.begin(), loop.end() - 2, loop.end());
  loop.erase(loop.begin() + 3);
  CHECK(withLoop(loop) != "");
}

void TestLocate()
{
  const Patches::Columns square = Patches::FromPicture({ "###", "###", "###" });
  const Loops loops = FindExteriorBoundary(square).Boundary;
  CHECK_EQUAL(MeshChecker::Locate(square, loops, { 1, 1 }), 1);
  CHECK_EQUAL(MeshChecker::Locate(square, loops, { 2, 1 }), 0);
  CHECK_EQUAL(MeshChecker::Locate(square, loops, { 3, 1 }), -1);
}
}

int TestMeshChecker(int, char*[])
{
  TestDamagedMeshes();
  TestNotDelaunay();
  TestDamagedBoundaries();
  TestLocate();
  return Check::Result();
}
