// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Edge collapse of CGAL with cost and placement of Lindstrom and Turk (1998, 1999), which keeps the outline.

#include "BenchmarkTools.h"
#include "DecimationPeers.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <array>
#include <vector>

using namespace SeismicHorizons;
using DecimationErrors::Surface;

namespace Simplification = CGAL::Surface_mesh_simplification;
namespace Processing = CGAL::Polygon_mesh_processing;

namespace DecimationPeers
{
namespace
{
using Point = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<Point>;
using Edge = CgalMesh::Edge_index;

struct IsOnOutline
{
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  friend bool get(const IsOnOutline& map, Edge edge) { return map.Mesh->is_border(edge); }

  const CgalMesh* Mesh;
};

/// CGAL counts edges, whose number for some vertices depends on the outline.
struct StopAtVertices
{
  template <typename Number, typename Profile>
  bool operator()(const Number&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= this->Vertices;
  }

  std::size_t Vertices;
};

/// Of all points. An outline that touches itself has a vertex for each time.
CgalMesh MakeMesh(const Surface& surface)
{
  const RawVector<PointId> all = Triangulate(surface.Horizon).Triangles;
  std::vector<Point> places;
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    places.emplace_back(surface.Columns[point].X, surface.Columns[point].Y, surface.Horizon.Height[point]);
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::size_t first = 0; first < all.size(); first += 3)
  {
    triangles.push_back({ std::size_t(all[first]), std::size_t(all[first + 1]), std::size_t(all[first + 2]) });
  }
  Processing::orient_polygon_soup(places, triangles);
  CgalMesh mesh;
  Processing::polygon_soup_to_polygon_mesh(places, triangles, mesh);
  for (const CgalMesh::Vertex_index vertex : mesh.vertices())
  {
    if (mesh.is_isolated(vertex))
    {
      mesh.remove_vertex(vertex);
    }
  }
  mesh.collect_garbage();
  return mesh;
}

void Collapse(CgalMesh& mesh, std::size_t vertices, bool isNormalChangeBounded)
{
  const IsOnOutline isOnOutline{ &mesh };
  const Simplification::Constrained_placement<Simplification::LindstromTurk_placement<CgalMesh>, IsOnOutline> placement(
    isOnOutline);
  const auto parameters = CGAL::parameters::edge_is_constrained_map(isOnOutline)
                            .get_cost(Simplification::LindstromTurk_cost<CgalMesh>())
                            .get_placement(placement);
  const StopAtVertices stop{ vertices };
  if (isNormalChangeBounded)
  {
    Simplification::edge_collapse(mesh, stop, parameters.filter(Simplification::Bounded_normal_change_filter<>()));
  }
  else
  {
    Simplification::edge_collapse(mesh, stop, parameters);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
Result RunCgal(const Surface& surface, std::size_t vertices, bool isNormalChangeBounded)
{
  const CgalMesh all = MakeMesh(surface);
  CgalMesh mesh;
  Result result;
  result.Seconds = BenchmarkTools::Time(
    [&]()
    {
      mesh = all;
      Collapse(mesh, vertices, isNormalChangeBounded);
    });
  mesh.collect_garbage();
  for (const CgalMesh::Vertex_index vertex : mesh.vertices())
  {
    const Point& place = mesh.point(vertex);
    result.Mesh.Vertices.push_back({ place.x(), place.y(), place.z() });
  }
  for (const CgalMesh::Face_index face : mesh.faces())
  {
    std::array<std::size_t, 3> corners{};
    std::size_t corner = 0;
    for (const CgalMesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face)))
    {
      corners[corner++] = std::size_t(vertex);
    }
    result.Mesh.Triangles.push_back(corners);
  }
  return result;
}
}
