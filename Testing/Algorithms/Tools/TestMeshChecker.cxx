// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker of meshes must find each kind of damage.

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
  const PlanePoint corner = mesh.Horizon.Plane[std::size_t(moved)];
  const int step = moved == 3 ? 100 : -100;
  mesh.Horizon.Plane[std::size_t(moved)] = { corner.X + step, corner.Y + 100 };
  CHECK_EQUAL(mesh.Check(), std::string());
  mesh.Horizon.Plane[std::size_t(moved)] = { corner.X - step, corner.Y - 100 };
  CHECK_EQUAL(mesh.Check().find("not Delaunay"), 0u);
}
}

int TestMeshChecker(int, char*[])
{
  TestDamagedMeshes();
  TestNotDelaunay();
  return Check::Result();
}
