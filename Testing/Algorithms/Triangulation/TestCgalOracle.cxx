// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes beside those of CGAL's constrained Delaunay triangulation. Built where CGAL is installed.

#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/TestHorizons.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <set>

using namespace TestHorizons;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointId, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Data = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data>;

using Edge = std::pair<PointId, PointId>;
using Thirds = std::map<Edge, PointId>; // by directed edge the third point to its left

Thirds Collect(const RawVector<PointId>& triangles)
{
  Thirds thirds;
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      thirds[{ triangles[corner + n], triangles[corner + (n + 1) % 3] }] = triangles[corner + (n + 2) % 3];
    }
  }
  return thirds;
}

/// The triangles of one patch that an odd number of boundary edges parts from the outside. A boundary edge that is
/// walked in both directions parts nothing.
RawVector<PointId> MeshWithCgal(const BoundedHorizon& horizon, std::int32_t patch)
{
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices(horizon.Plane.size());
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    if (horizon.Patch[point] == patch)
    {
      vertices[point] = cdt.insert({ double(horizon.Plane[point].X), double(horizon.Plane[point].Y) });
      vertices[point]->info() = PointId(point);
    }
  }
  std::set<Edge> walls;
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      if (horizon.Patch[from] == patch)
      {
        cdt.insert_constraint(vertices[from], vertices[to]);
        const Edge wall = std::minmax(from, to);
        if (walls.erase(wall) == 0)
        {
          walls.insert(wall);
        }
      }
    });
  if (cdt.dimension() < 2) // all on one line
  {
    return {};
  }
  std::map<Cdt::Face_handle, bool> inside = { { cdt.infinite_face(), false } };
  std::vector<Cdt::Face_handle> front = { cdt.infinite_face() };
  while (!front.empty())
  {
    const Cdt::Face_handle face = front.back();
    front.pop_back();
    for (int n = 0; n < 3; ++n)
    {
      const Cdt::Vertex_handle a = face->vertex(cdt.cw(n));
      const Cdt::Vertex_handle b = face->vertex(cdt.ccw(n));
      const bool wall =
        !cdt.is_infinite(a) && !cdt.is_infinite(b) && walls.count(std::minmax(a->info(), b->info())) != 0;
      if (inside.insert({ face->neighbor(n), inside[face] != wall }).second)
      {
        front.push_back(face->neighbor(n));
      }
    }
  }
  RawVector<PointId> triangles;
  for (const auto& [face, isInside] : inside)
  {
    for (int n = 0; isInside && n < 3; ++n)
    {
      triangles.push_back(face->vertex(n)->info());
    }
  }
  return triangles;
}

/// Whether two meshes differ only where four points are on one circle: an edge of one that the other lacks parts two
/// such triangles.
bool DifferByTiesOnly(const BoundedHorizon& horizon, const Thirds& one, const Thirds& other)
{
  const auto at = [&horizon](PointId point) { return horizon.Plane[point]; };
  for (const auto& [edge, third] : one)
  {
    const Edge back(edge.second, edge.first);
    if (other.count(edge) != 0 || other.count(back) != 0)
    {
      continue;
    }
    const auto opposite = one.find(back);
    if (opposite == one.end() ||
      ExactPlane::SideOfCircle(at(edge.first), at(edge.second), at(third), at(opposite->second)) != 0)
    {
      return false;
    }
  }
  return true;
}

void Compare(const BoundedHorizon& horizon)
{
  const RawVector<PointId> ours = Triangulate(horizon).Triangles;
  RawVector<PointId> theirs;
  for (const std::int32_t patch : std::set<std::int32_t>(horizon.Patch.begin(), horizon.Patch.end()))
  {
    const RawVector<PointId> triangles = MeshWithCgal(horizon, patch);
    theirs.insert(theirs.end(), triangles.begin(), triangles.end());
  }
  CHECK_EQUAL(ours.size(), theirs.size());
  CHECK(DifferByTiesOnly(horizon, Collect(ours), Collect(theirs)));
  CHECK(DifferByTiesOnly(horizon, Collect(theirs), Collect(ours)));
}
}

int TestCgalOracle(int, char*[])
{
  Patches::Random random(12);
  for (int n = 0; n < 600; ++n)
  {
    const Patches::Columns columns = Patches::Make(Patches::Shape(n % int(Patches::Shape::Count)), random);
    const BoundedHorizon full = MakeHorizon(columns, MakeHeights(columns, random));
    Compare(full);
    const BoundedHorizon straight = Drop(full, SimplifyBoundary(full, full.Boundary, 3.0 * random.Fraction()));
    Compare(straight);
    Compare(Reduce(straight, SimplifyRough(straight, 1 + random.Below(7))));
  }
  return Check::Result();
}
