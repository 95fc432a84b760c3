// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Speed of the searches for the nearest triangle, beside VTK's in the same run, all on one thread: from every point of
// a generated horizon to a mesh of about a tenth of its points. Prints Markdown: processor seconds, the least of
// several runs, and by how much results differ. Then both our searches at places on faces, both ways and in two
// metrics, and the whole measure on one and on two threads with the memory that it takes.
//
//   SurfaceDistanceBenchmark [--ours] [POINTS ...]      sizes of the horizons; without them 886639; --ours: without VTK

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/SurfaceDistance/DistanceProbe.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/TestHorizons.h"

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
#include <cstring>
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

/// VTK's searches.
void ReportPeers(const TriangleSurface& full, const TriangleSurface& mesh, double ours, const Distances& exact)
{
  const vtkSmartPointer<vtkPolyData> data = ToVtk(mesh);
  ReportLocator(vtkNew<vtkStaticCellLocator>(), data, full, ours, exact);
  ReportLocator(vtkNew<vtkCellLocator>(), data, full, ours, exact);
  vtkNew<vtkImplicitPolyDataDistance> implicit;
  const double build = Time([&]() { implicit->SetInput(data); });
  Distances found;
  const double query = Time([&]() { found = MeasureByImplicit(full, implicit); });
  Report("vtkImplicitPolyDataDistance", build, query, ours, found, exact);
}

Distances MeasureByRaster(const TriangleSurface& from, const TriangleSearch& search)
{
  Distances distances;
  const std::vector<Metric> metrics = { Metric() };
  DistanceProbe probe(search, metrics);
  for (const Eigen::Vector3d& point : from.Points)
  {
    distances.push_back(probe(point)[0]);
  }
  return distances;
}

void ReportPoints(const TriangleSurface& full, const TriangleSurface& mesh, bool withPeers)
{
  std::printf("| search | build s | queries s | million queries/s | time / tree | largest difference |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  Distances exact;
  const double build = Time([&]() { TriangleTree tree(mesh); });
  const TriangleTree tree(mesh);
  const double ofTree = Time([&]() { exact = MeasureByTree(full, tree); });
  Report("TriangleTree", build, ofTree, ofTree, exact, exact);
  const double rasterBuild = Time([&]() { TriangleSearch search(mesh); });
  const TriangleSearch search(mesh);
  Distances found;
  const double ofRaster = Time([&]() { found = MeasureByRaster(full, search); });
  Report(search.GetRaster() != nullptr ? "TriangleRaster" : "TriangleTree, no raster", rasterBuild, ofRaster, ofTree,
    found, exact);
  if (withPeers)
  {
    ReportPeers(full, mesh, ofTree, exact);
  }
}

/// Columns of 25 by 12.5, and a vertical step of 4.
Metric World()
{
  return Metric((Eigen::Matrix2d() << 15.0, -10.0, 20.0, 7.5).finished(), 4.0);
}

/// As many places on faces as the measure takes by default.
std::vector<Eigen::Vector3d> MakePlaces(const TriangleSurface& surface, double count)
{
  double area = 0.0;
  for (const Corners& t : surface.Triangles)
  {
    area += surface.Area(t);
  }
  std::vector<Eigen::Vector3d> places;
  for (std::size_t n = 0; n < surface.Triangles.size(); ++n)
  {
    const Corners& t = surface.Triangles[n];
    const std::int64_t samples = std::max<std::int64_t>(1, std::llround(surface.Area(t) / area * count));
    SampleTriangle(surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]), samples, Scramble(n),
      [&places](const Eigen::Vector3d& place) { places.push_back(place); });
  }
  return places;
}

/// Both our searches from places on faces, in both metrics; and by how much they differ at most.
void ReportFaces(const char* name, const TriangleSurface& from, const TriangleSurface& to, double count)
{
  const std::vector<Eigen::Vector3d> places = MakePlaces(from, count);
  const TriangleTree tree(to);
  const TriangleSearch search(to);
  std::vector<double> byTree(2 * places.size());
  std::vector<double> byRaster(2 * places.size());
  const std::vector<Metric> metrics = { Metric(), World() };
  const auto perSecond = [&](double seconds) { return 2e-6 * double(places.size()) / seconds; };
  const double ofTree = Time(
    [&]()
    {
      std::int32_t hints[2] = { 0, 0 };
      for (std::size_t n = 0; n < byTree.size(); ++n)
      {
        byTree[n] = std::sqrt(tree.SquaredDistance(places[n / 2], hints[n % 2], metrics[n % 2]));
      }
    });
  const double ofRaster = Time(
    [&]()
    {
      DistanceProbe probe(search, metrics);
      for (std::size_t n = 0; n < places.size(); ++n)
      {
        const auto& found = probe(places[n]);
        byRaster[2 * n] = found[0];
        byRaster[2 * n + 1] = found[1];
      }
    });
  const auto inOne = [&](const Metric& metric)
  {
    const std::vector<Metric> one = { metric };
    return 0.5 *
      perSecond(Time(
        [&]()
        {
          DistanceProbe probe(search, one);
          for (const Eigen::Vector3d& place : places)
          {
            probe(place);
          }
        }));
  };
  double difference = 0.0;
  for (std::size_t n = 0; n < byTree.size(); ++n)
  {
    difference = std::max(difference, std::abs(byTree[n] - byRaster[n]) / (1.0 + byTree[n]));
  }
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.1e |\n", name, places.size(), perSecond(ofTree),
    perSecond(ofRaster), inOne(metrics[0]), inOne(metrics[1]), difference);
  std::fflush(stdout);
}

/// The whole measure, in one metric and in two.
void ReportWhole(const TriangleSurface& full, const TriangleSurface& mesh)
{
  std::printf("\n| metrics | threads | seconds | bytes per triangle | samples on faces | largest | mean |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::vector<Metric>& metrics :
    { std::vector<Metric>{ Metric() }, std::vector<Metric>{ Metric(), World() } })
  {
    for (const int threads : { 1, 2 })
    {
      Detail::NumberOfThreads() = threads;
      std::vector<SurfaceDistance> found;
      const auto measure = [&]() { found = MeasureSurfaceDistances(full, mesh, metrics); };
      const double bytes = PeakBytes(measure);
      const double seconds = Time(measure, CLOCK_MONOTONIC);
      const DistanceFigures& figures = found.back().TwoSided;
      std::printf("| %zu | %d | %.3f | %.1f | %lld | %.6f | %.6f |\n", metrics.size(), threads, seconds,
        bytes / double(full.Triangles.size() + mesh.Triangles.size()), static_cast<long long>(figures.Samples),
        figures.Largest, figures.Mean);
      std::fflush(stdout);
    }
  }
  Detail::NumberOfThreads() = 1;
}

void Benchmark(std::int64_t size, bool withPeers)
{
  const BoundedHorizon horizon = MakeGenerated(size);
  const TriangleSurface full = Mesh(horizon);
  const TriangleSurface mesh = MeshSimplified(horizon);
  std::printf("%zu points and %zu triangles to %zu points and %zu triangles\n\n", full.Points.size(),
    full.Triangles.size(), mesh.Points.size(), mesh.Triangles.size());
  ReportPoints(full, mesh, withPeers);
  std::printf(
    "\n| million distances/s from places on faces | places | tree, both metrics | raster, both | first | second "
    "| largest difference |\n| --- | --- | --- | --- | --- | --- | --- |\n");
  const double count = 2.0 * double(full.Points.size());
  ReportFaces("full to mesh", full, mesh, count);
  ReportFaces("mesh to full", mesh, full, count);
  ReportWhole(full, mesh);
  std::printf("\n");
}
}

int main(int argc, char* argv[])
{
  Detail::NumberOfThreads() = 1;
  bool withPeers = true;
  std::vector<std::int64_t> sizes;
  for (int n = 1; n < argc; ++n)
  {
    const bool isOption = std::strcmp(argv[n], "--ours") == 0;
    withPeers = withPeers && !isOption;
    if (!isOption)
    {
      sizes.push_back(std::atoll(argv[n]));
    }
  }
  for (const std::int64_t size : sizes.empty() ? std::vector<std::int64_t>{ 886639 } : sizes)
  {
    Benchmark(size, withPeers);
  }
  return EXIT_SUCCESS;
}
