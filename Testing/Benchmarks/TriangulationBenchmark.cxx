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
#include "ElaborateSimplification.h"
#include "Parallel.h"
#include "RoughSimplification.h"
#include "TestHorizons.h"
#include "Triangulation.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

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

/// All points and the outline; triangles outside it are left in.
void TimeCgalConstrained(const std::vector<Kernel::Point_2>& points, const Loops& boundary)
{
  std::vector<std::pair<std::size_t, std::size_t>> hops;
  boundary.ForEachHop([&hops](PointId from, PointId to) { hops.emplace_back(from, to); });
  Constrained mesh;
  mesh.insert_constraints(points.begin(), points.end(), hops.begin(), hops.end());
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
  const double vtk = size > MostForVtk ? NAN : Time([&]() { TimeVtk(horizon); });
  Detail::NumberOfThreads() = int(std::thread::hardware_concurrency());
  const double byTheClock = Time([&]() { Triangulate(horizon); }, CLOCK_MONOTONIC);
  const double bytes = PeakBytes([&]() { Triangulate(horizon); });
  std::printf("| %s | %zu | %.5f | %.5f | %.5f | %.5f | %.3f | %.1f | %.1f | %.1f | %.5f | %.1f | %.0f |\n", what, size,
    traversal, compactness, cgal, constrained, vtk, 1e-6 * double(size) / traversal, cgal / traversal,
    constrained / traversal, byTheClock, 1e-6 * double(size) / byTheClock, bytes / double(size));
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
              "bytes per point |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
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
