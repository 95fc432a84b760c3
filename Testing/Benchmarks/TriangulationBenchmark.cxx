// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times the triangulation beside CGAL and VTK on generated horizons, in one run. Prints Markdown: processor seconds on
// one thread, the least of several runs; at the end what it takes by the clock on all threads, and memory.
//
//   TriangulationBenchmark [--full] [POINTS ...]
//
// POINTS are the sizes of the horizons; without them those of the thesis's table 5.1. With --full, horizons with all
// their points only.

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/TestHorizons.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace SeismicHorizons;
using namespace BenchmarkTools;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

// With the number of each point, and how many boundary edges part a face from the outside.
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointId, Kernel>;
using FaceBase =
  CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Numbered =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

// Above so many points a peer that takes longer than linear time is left out.
constexpr std::size_t MostForVtk = 70000;
constexpr std::size_t MostForConstrained = 2000000;

std::vector<Kernel::Point_2> ToCgal(const BoundedHorizon& horizon)
{
  std::vector<Kernel::Point_2> points;
  for (const PlanePoint& place : horizon.Plane)
  {
    points.emplace_back(place.X, place.Y);
  }
  return points;
}

void TimeCgal(const std::vector<Kernel::Point_2>& points)
{
  Delaunay mesh;
  mesh.insert(points.begin(), points.end());
}

/// All points and the outline, no more: triangles outside it are left in.
void TimeCgalConstrained(const std::vector<Kernel::Point_2>& points, const Loops& boundary)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  boundary.ForEachEdge([&edges](PointId from, PointId to) { edges.emplace_back(from, to); });
  Constrained mesh;
  mesh.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
}

constexpr int Unknown = -1;

/// Numbers the faces that can be reached from one without crossing a constraint, and collects those behind constraints.
void FloodFaces(
  const Numbered& mesh, Numbered::Face_handle start, int level, std::vector<Numbered::Face_handle>& beyond)
{
  std::vector<Numbered::Face_handle> front = { start };
  while (!front.empty())
  {
    const Numbered::Face_handle face = front.back();
    front.pop_back();
    if (face->info() != Unknown)
    {
      continue;
    }
    face->info() = level;
    for (int n = 0; n < 3; ++n)
    {
      const Numbered::Face_handle neighbor = face->neighbor(n);
      if (neighbor->info() == Unknown)
      {
        (mesh.is_constrained({ face, n }) ? beyond : front).push_back(neighbor);
      }
    }
  }
}

/// What we give, too: three points for each triangle inside.
std::vector<PointId> MeshInsideByCgal(const BoundedHorizon& horizon)
{
  std::vector<std::pair<Kernel::Point_2, PointId>> points;
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    points.emplace_back(Kernel::Point_2(horizon.Plane[point].X, horizon.Plane[point].Y), PointId(point));
  }
  Numbered mesh;
  mesh.insert(points.begin(), points.end());
  std::vector<Numbered::Vertex_handle> vertices(points.size());
  for (const Numbered::Vertex_handle vertex : mesh.finite_vertex_handles())
  {
    vertices[std::size_t(vertex->info())] = vertex;
  }
  horizon.Boundary.ForEachEdge(
    [&](PointId from, PointId to) { mesh.insert_constraint(vertices[std::size_t(from)], vertices[std::size_t(to)]); });
  for (const Numbered::Face_handle face : mesh.all_face_handles())
  {
    face->info() = Unknown;
  }
  std::vector<Numbered::Face_handle> level = { mesh.infinite_face() };
  for (int number = 0; !level.empty(); ++number)
  {
    std::vector<Numbered::Face_handle> beyond;
    for (const Numbered::Face_handle face : level)
    {
      FloodFaces(mesh, face, number, beyond);
    }
    level.swap(beyond);
  }
  std::vector<PointId> triangles;
  for (const Numbered::Face_handle face : mesh.finite_face_handles())
  {
    for (int n = 0; face->info() % 2 == 1 && n < 3; ++n)
    {
      triangles.push_back(face->vertex(n)->info());
    }
  }
  return triangles;
}

void TimeVtk(const BoundedHorizon& horizon)
{
  vtkNew<vtkPoints> points;
  for (const PlanePoint& place : horizon.Plane)
  {
    points->InsertNextPoint(place.X, place.Y, 0.0);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(input);
  delaunay->SetTolerance(0.0);
  delaunay->Update();
}

void PrintRow(const char* what, const BoundedHorizon& horizon)
{
  const std::size_t size = horizon.Plane.size();
  Detail::NumberOfThreads() = 1;
  const double traversal = Time([&]() { Triangulate(horizon); });
  const double compactness = Time([&]() { Triangulate(horizon, { SearchStrategy::Compactness }); });
  const std::vector<Kernel::Point_2> points = ToCgal(horizon);
  const double cgal = Time([&]() { TimeCgal(points); });
  const double constrained =
    size > MostForConstrained ? NAN : Time([&]() { TimeCgalConstrained(points, horizon.Boundary); });
  std::size_t corners = 0;
  const double inside = size > MostForConstrained ? NAN : Time([&]() { corners = MeshInsideByCgal(horizon).size(); });
  if (size <= MostForConstrained && corners != Triangulate(horizon).Triangles.size())
  {
    std::printf("CGAL has %zu triangles inside the outline, expected as many as we have\n", corners / 3);
    std::exit(EXIT_FAILURE);
  }
  const double vtk = size > MostForVtk ? NAN : Time([&]() { TimeVtk(horizon); });
  Detail::NumberOfThreads() = int(std::thread::hardware_concurrency());
  const double byTheClock = Time([&]() { Triangulate(horizon); }, CLOCK_MONOTONIC);
  const double bytes = PeakBytes([&]() { Triangulate(horizon); });
  std::printf(
    "| %s | %zu | %.5f | %.5f | %.5f | %.5f | %.3f | %.1f | %.1f | %.1f | %.5f | %.1f | %.0f | %.5f | %.1f |\n", what,
    size, traversal, compactness, cgal, constrained, vtk, 1e-6 * double(size) / traversal, cgal / traversal,
    constrained / traversal, byTheClock, 1e-6 * double(size) / byTheClock, bytes / double(size), inside,
    inside / traversal);
  std::fflush(stdout);
}
}

int main(int argc, char* argv[])
{
  std::vector<std::int64_t> sizes;
  const bool fullOnly = argc > 1 && std::string(argv[1]) == "--full";
  for (int n = fullOnly ? 2 : 1; n < argc; ++n)
  {
    sizes.push_back(std::atoll(argv[n]));
  }
  if (sizes.empty())
  {
    sizes = { 15626, 32402, 60511, 68956, 98231, 148317, 886639 };
  }
  std::printf("| horizon | points | VTS s | CTC s | CGAL Delaunay s | CGAL constrained s | vtkDelaunay2D s | "
              "VTS Mpoints/s | CGAL Delaunay / VTS | CGAL constrained / VTS | VTS s, all threads | Mpoints/s | "
              "bytes per point | CGAL inside s | CGAL inside / VTS |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::int64_t size : sizes)
  {
    const BoundedHorizon full = MakeGenerated(size);
    PrintRow("full", full);
    if (fullOnly)
    {
      continue;
    }
    const BoundedHorizon straight = Straighten(full);
    PrintRow("outline simplified", straight);
    PrintRow("simplified", TestHorizons::Reduce(straight, SimplifyRough(straight, 3)));
    PrintRow("elaborate", TestHorizons::Reduce(straight, SimplifyElaborate(straight, ElaborateOptions())));
  }
  return EXIT_SUCCESS;
}
