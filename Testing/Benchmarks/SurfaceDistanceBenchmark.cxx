// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Speed of the search for the nearest triangle, beside VTK's searches in the same run, all on one thread: from every
// point of a generated horizon to a mesh of about a tenth of its points. Prints Markdown: processor seconds, the least
// of several runs, and by how much results differ. Then the whole measure, on one thread.
//
//   SurfaceDistanceBenchmark [POINTS ...]      sizes of the horizons; without them 886639

#include "BenchmarkTools.h"
#include "CellSimplification/RoughSimplification.h"
#include "Common/Parallel.h"
#include "SurfaceDistance/SurfaceDistance.h"
#include "SurfaceDistance/TriangleTree.h"
#include "Tools/TestHorizons.h"
#include "Triangulation/Triangulation.h"

#include "vtkCellArray.h"
#include "vtkCellLocator.h"
#include "vtkGenericCell.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace SeismicHorizons;
using namespace BenchmarkTools;

namespace
{
TriangleSurface Mesh(const BoundedHorizon& horizon)
{
  TriangleSurface surface;
  for (const SpacePoint& point : TestHorizons::ToSpacePoints(horizon))
  {
    surface.Points.emplace_back(point.X, point.Y, point.Z);
  }
  const RawVector<PointId> triangles = Triangulate(horizon).Triangles;
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    surface.Triangles.push_back({ triangles[corner], triangles[corner + 1], triangles[corner + 2] });
  }
  return surface;
}

TriangleSurface MeshSimplified(const BoundedHorizon& horizon)
{
  const BoundedHorizon straight = Straighten(horizon);
  return Mesh(TestHorizons::Reduce(straight, SimplifyRough(straight, 3)));
}

vtkSmartPointer<vtkPolyData> ToVtk(const TriangleSurface& surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : surface.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const Corners& t : surface.Triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

using Distances = std::vector<double>;

Distances MeasureByTree(const TriangleSurface& from, const TriangleTree& tree)
{
  Distances distances;
  std::int32_t hint = 0;
  for (const Eigen::Vector3d& point : from.Points)
  {
    distances.push_back(std::sqrt(tree.SquaredDistance(point, hint)));
  }
  return distances;
}

Distances MeasureByLocator(const TriangleSurface& from, vtkAbstractCellLocator* locator)
{
  Distances distances;
  vtkNew<vtkGenericCell> cell;
  for (const Eigen::Vector3d& point : from.Points)
  {
    double closest[3];
    vtkIdType id = 0;
    int subId = 0;
    double squared = 0.0;
    locator->FindClosestPoint(point.data(), closest, cell, id, subId, squared);
    distances.push_back(std::sqrt(squared));
  }
  return distances;
}

/// What vtkDistancePolyDataFilter does for each point.
Distances MeasureByImplicit(const TriangleSurface& from, vtkImplicitPolyDataDistance* implicit)
{
  Distances distances;
  for (const Eigen::Vector3d& point : from.Points)
  {
    distances.push_back(std::abs(implicit->EvaluateFunction(point.x(), point.y(), point.z())));
  }
  return distances;
}

void Report(const char* name, double build, double query, double ours, const Distances& found, const Distances& exact)
{
  double difference = 0.0;
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    difference = std::max(difference, std::abs(found[n] - exact[n]));
  }
  std::printf("| %s | %.3f | %.3f | %.3f | %.1f | %.1e |\n", name, build, query, 1e-6 * double(found.size()) / query,
    query / ours, difference);
  std::fflush(stdout);
}

void ReportLocator(
  vtkAbstractCellLocator* locator, vtkPolyData* mesh, const TriangleSurface& full, double ours, const Distances& exact)
{
  locator->SetDataSet(mesh);
  locator->CacheCellBoundsOn();
  const double build = Time([&]() { locator->ForceBuildLocator(); });
  Distances found;
  const double query = Time([&]() { found = MeasureByLocator(full, locator); });
  Report(locator->GetClassName(), build, query, ours, found, exact);
}

void Benchmark(std::int64_t size)
{
  const BoundedHorizon horizon = MakeGenerated(size);
  const TriangleSurface full = Mesh(horizon);
  const TriangleSurface mesh = MeshSimplified(horizon);
  std::printf(
    "%zu points to %zu points and %zu triangles\n\n", full.Points.size(), mesh.Points.size(), mesh.Triangles.size());
  std::printf("| search | build s | queries s | million queries/s | time / ours | largest difference |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  Distances exact;
  const double build = Time([&]() { TriangleTree tree(mesh); });
  const TriangleTree tree(mesh);
  const double ours = Time([&]() { exact = MeasureByTree(full, tree); });
  Report("TriangleTree", build, ours, ours, exact, exact);
  const vtkSmartPointer<vtkPolyData> data = ToVtk(mesh);
  ReportLocator(vtkNew<vtkStaticCellLocator>(), data, full, ours, exact);
  ReportLocator(vtkNew<vtkCellLocator>(), data, full, ours, exact);
  vtkNew<vtkImplicitPolyDataDistance> implicit;
  const double implicitBuild = Time([&]() { implicit->SetInput(data); });
  Distances found;
  const double query = Time([&]() { found = MeasureByImplicit(full, implicit); });
  Report("vtkImplicitPolyDataDistance", implicitBuild, query, ours, found, exact);
  SurfaceDistance distance;
  const double whole = Time([&]() { distance = MeasureSurfaceDistance(full, mesh); });
  std::printf("\nThe whole measure, both ways: %.3f s; %lld samples on faces; largest %.6f, mean %.6f\n\n", whole,
    static_cast<long long>(distance.TwoSided.Samples), distance.TwoSided.Largest, distance.TwoSided.Mean);
}
}

int main(int argc, char* argv[])
{
  Detail::NumberOfThreads() = 1;
  for (int n = 1; n < argc; ++n)
  {
    Benchmark(std::atoll(argv[n]));
  }
  if (argc == 1)
  {
    Benchmark(886639);
  }
  return EXIT_SUCCESS;
}
