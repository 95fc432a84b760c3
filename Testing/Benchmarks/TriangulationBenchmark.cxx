// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times the triangulation beside CGAL and VTK on generated horizons, in one run. Prints Markdown: processor seconds,
// the least of several runs.
//
//   TriangulationBenchmark [POINTS ...]      sizes of the horizons; without them those of the thesis's table 5.1

#include "HorizonGenerator.h"
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

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

// Above so many points a peer that takes longer than linear time is left out.
constexpr std::size_t MostForVtk = 70000;
constexpr std::size_t MostForConstrained = 2000000;

double ProcessorSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// The least of several runs, of as many as fit into about a second, at least one.
template <typename Work>
double Time(Work&& work)
{
  double least = 0.0;
  double total = 0.0;
  for (int run = 0; run == 0 || (run < 9 && total < 1.0); ++run)
  {
    const double start = ProcessorSeconds();
    work();
    const double seconds = ProcessorSeconds() - start;
    least = run == 0 ? seconds : std::min(least, seconds);
    total += seconds;
  }
  return least;
}

BoundedHorizon MakeGenerated(std::int64_t numberOfPoints)
{
  HorizonGeneratorOptions options;
  options.NumberOfHorizons = 1;
  options.Size = HorizonGenerator::FindSize(options, numberOfPoints);
  const HorizonVoxels voxels = HorizonGenerator(options).MakeHorizon(0);
  std::vector<PlanePoint> columns;
  for (std::size_t voxel = 0; voxel < voxels.I.size(); ++voxel)
  {
    columns.push_back({ voxels.I[voxel], voxels.J[voxel] });
  }
  return TestHorizons::MakeHorizon(columns, std::vector<double>(voxels.K.begin(), voxels.K.end()));
}

/// After the boundary and the rough simplification with their defaults.
BoundedHorizon Simplify(const BoundedHorizon& horizon)
{
  const BoundedHorizon straight =
    TestHorizons::Drop(horizon, SimplifyBoundary(TestHorizons::ToSpacePoints(horizon), horizon.Boundary, 0.4));
  return TestHorizons::Reduce(straight, SimplifyRough(straight, 3));
}

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
  const double traversal = Time([&]() { Triangulate(horizon); });
  const double compactness = Time([&]() { Triangulate(horizon, { SearchStrategy::Compactness }); });
  const std::vector<Kernel::Point_2> points = ToCgal(horizon);
  const double cgal = Time([&]() { TimeCgal(points); });
  const double constrained =
    size > MostForConstrained ? NAN : Time([&]() { TimeCgalConstrained(points, horizon.Boundary); });
  const double vtk = size > MostForVtk ? NAN : Time([&]() { TimeVtk(horizon); });
  std::printf("| %s | %zu | %.5f | %.5f | %.5f | %.5f | %.3f | %.1f | %.1f | %.1f |\n", what, size, traversal,
    compactness, cgal, constrained, vtk, 1e-6 * double(size) / traversal, cgal / traversal, constrained / traversal);
  std::fflush(stdout);
}
}

int main(int argc, char* argv[])
{
  std::vector<std::int64_t> sizes;
  for (int n = 1; n < argc; ++n)
  {
    sizes.push_back(std::atoll(argv[n]));
  }
  if (sizes.empty())
  {
    sizes = { 15626, 32402, 60511, 68956, 98231, 148317, 886639 };
  }
  std::printf("| horizon | points | VTS s | CTC s | CGAL Delaunay s | CGAL constrained s | vtkDelaunay2D s | "
              "VTS Mpoints/s | CGAL Delaunay / VTS | CGAL constrained / VTS |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::int64_t size : sizes)
  {
    const BoundedHorizon full = MakeGenerated(size);
    PrintRow("full", full);
    PrintRow("simplified", Simplify(full));
  }
  return EXIT_SUCCESS;
}
