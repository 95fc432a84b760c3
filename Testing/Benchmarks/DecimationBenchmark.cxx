// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the decimation on generated horizons beside vtkGreedyTerrainDecimation, and meshoptimizer where it was
// found, at as many vertices. Prints Markdown.
//
//   DecimationBenchmark [POINTS]...     (148317 886639 when none is given)
//
// Seconds are those of the clock, the least of several runs, on all threads; peers have one. Errors are vertical, in
// voxels, at all points of the horizon that the mesh covers. Peers start from what they need: the greedy insertion from
// the filled box, with heights of the nearest point of the row where there is none; meshoptimizer from the mesh of all
// points, whose outline it keeps.

#include "BenchmarkTools.h"
#include "Decimation/Decimation.h"
#include "Decimation/HeightRaster.h"
#include "Triangulation/Triangulation.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkGreedyTerrainDecimation.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// A generated horizon by columns, with real or with whole heights, its outline simplified within half a voxel.
struct Surface
{
  Surface(std::int64_t points, bool isReal)
    : Horizon(Straighten(BenchmarkTools::MakeGenerated(points), points, isReal))
  {
    for (const PlanePoint& place : this->Horizon.Plane)
    {
      this->Columns.push_back(
        { place.X / this->Horizon.SubVoxelsPerColumn, place.Y / this->Horizon.SubVoxelsPerColumn });
    }
    std::vector<PointId> all(this->Columns.size());
    std::iota(all.begin(), all.end(), 0);
    this->Raster = std::make_unique<HeightRaster>(all, this->Columns, this->Horizon.Height);
  }

  static BoundedHorizon Straighten(BoundedHorizon horizon, std::int64_t points, bool isReal)
  {
    if (isReal)
    {
      HorizonGeneratorOptions options;
      options.NumberOfHorizons = 1;
      options.Size = HorizonGenerator::FindSize(options, points);
      const HorizonVoxels voxels = HorizonGenerator(options).MakeHorizon(0);
      horizon.Height.assign(voxels.RealZ.begin(), voxels.RealZ.end());
    }
    BoundarySimplificationOptions options;
    options.DistanceThreshold = 0.5;
    options.OutlineTolerance = 0.5;
    return TestHorizons::Drop(
      horizon, SimplifyBoundary(TestHorizons::ToSpacePoints(horizon), horizon.Boundary, options));
  }

  BoundedHorizon Horizon;
  std::vector<PlanePoint> Columns;
  std::unique_ptr<HeightRaster> Raster;
};

/// Vertices of a mesh by column, with heights, and its triangles.
struct Mesh
{
  std::vector<RaisedPoint> Vertices;
  std::vector<std::array<std::size_t, 3>> Triangles;
};

void PrintRow(const char* method, const Surface& surface, const Mesh& mesh, double seconds)
{
  double sum = 0.0;
  double largest = 0.0;
  std::size_t count = 0;
  for (const auto& corners : mesh.Triangles)
  {
    RaisedTriangle triangle = { mesh.Vertices[corners[0]], mesh.Vertices[corners[1]], mesh.Vertices[corners[2]] };
    const std::int64_t area = SignedArea(triangle[0].Column, triangle[1].Column, triangle[2].Column);
    if (area == 0)
    {
      continue;
    }
    if (area < 0)
    {
      std::swap(triangle[0], triangle[1]);
    }
    surface.Raster->ForEachColumn(triangle,
      [&](PointId, double error, const std::array<double, 3>&)
      {
        sum += std::abs(error);
        largest = std::max(largest, std::abs(error));
        ++count;
      });
  }
  std::printf(
    "| %s | %zu | %.3f | %.4f | %.3f |\n", method, mesh.Vertices.size(), seconds, sum / double(count), largest);
  std::fflush(stdout);
}

Mesh ToMesh(const Surface& surface, const Decimation& decimation)
{
  Mesh mesh;
  for (std::size_t vertex = 0; vertex < decimation.Points.Source.size(); ++vertex)
  {
    mesh.Vertices.push_back(
      { surface.Columns[std::size_t(decimation.Points.Source[vertex])], decimation.Points.Height[vertex] });
  }
  for (std::size_t first = 0; first < decimation.Triangles.size(); first += 3)
  {
    mesh.Triangles.push_back({ std::size_t(decimation.Triangles[first]), std::size_t(decimation.Triangles[first + 1]),
      std::size_t(decimation.Triangles[first + 2]) });
  }
  return mesh;
}

void RunOwn(const char* name, const Surface& surface, std::size_t vertices, bool fitHeights)
{
  DecimationOptions options;
  options.MaximumError = 0.0;
  options.MaximumNumberOfPoints = vertices;
  options.FitHeights = fitHeights;
  Decimation decimation;
  const double seconds =
    BenchmarkTools::Time([&]() { decimation = Decimate(surface.Horizon, options); }, CLOCK_MONOTONIC);
  PrintRow(name, surface, ToMesh(surface, decimation), seconds);
}

/// The heights of the whole box.
vtkSmartPointer<vtkImageData> FillBox(const Surface& surface)
{
  const PlaneBox box(surface.Columns);
  const int width = box.Greatest.X + 1;
  const int height = box.Greatest.Y + 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(vtkIdType(width) * height);
  heights->FillValue(NAN);
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    const PlanePoint& column = surface.Columns[point];
    heights->SetValue(vtkIdType(column.Y) * width + column.X, float(surface.Horizon.Height[point]));
  }
  float last = float(surface.Horizon.Height.front());
  for (vtkIdType place = 0; place < heights->GetNumberOfTuples(); ++place)
  {
    last = std::isnan(heights->GetValue(place)) ? last : heights->GetValue(place);
    heights->SetValue(place, last);
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

void RunGreedyTerrain(const Surface& surface, std::size_t triangles)
{
  const vtkSmartPointer<vtkImageData> image = FillBox(surface);
  vtkNew<vtkGreedyTerrainDecimation> greedy;
  greedy->SetInputData(image);
  greedy->SetErrorMeasureToNumberOfTriangles();
  greedy->SetNumberOfTriangles(vtkIdType(triangles));
  greedy->BoundaryVertexDeletionOn();
  const double seconds = BenchmarkTools::Time(
    [&]()
    {
      greedy->Modified();
      greedy->Update();
    },
    CLOCK_MONOTONIC);
  Mesh mesh;
  vtkPolyData* const output = greedy->GetOutput();
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const double* const place = output->GetPoint(point);
    mesh.Vertices.push_back({ { std::int32_t(std::lround(place[0])), std::int32_t(std::lround(place[1])) }, place[2] });
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (output->GetPolys()->InitTraversal(); output->GetPolys()->GetNextCell(size, corners) != 0;)
  {
    mesh.Triangles.push_back({ std::size_t(corners[0]), std::size_t(corners[1]), std::size_t(corners[2]) });
  }
  PrintRow("vtkGreedyTerrainDecimation, filled box", surface, mesh, seconds);
}

#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
void RunMeshoptimizer(const Surface& surface, std::size_t triangles)
{
  const RawVector<PointId> all = Triangulate(surface.Horizon).Triangles;
  const std::vector<unsigned int> indices(all.begin(), all.end());
  std::vector<float> places;
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    places.insert(places.end(),
      { float(surface.Columns[point].X), float(surface.Columns[point].Y), float(surface.Horizon.Height[point]) });
  }
  std::vector<unsigned int> left(indices.size());
  const double seconds = BenchmarkTools::Time(
    [&]()
    {
      left.resize(indices.size());
      left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), places.data(), surface.Columns.size(),
        3 * sizeof(float), 3 * triangles, 1.0F, meshopt_SimplifyLockBorder));
    },
    CLOCK_MONOTONIC);
  Mesh mesh;
  std::vector<std::size_t> number(surface.Columns.size(), surface.Columns.size());
  for (std::size_t first = 0; first < left.size(); first += 3)
  {
    std::array<std::size_t, 3> triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t point = left[first + corner];
      if (number[point] == surface.Columns.size())
      {
        number[point] = mesh.Vertices.size();
        mesh.Vertices.push_back({ surface.Columns[point], surface.Horizon.Height[point] });
      }
      triangle[corner] = number[point];
    }
    mesh.Triangles.push_back(triangle);
  }
  PrintRow("meshoptimizer", surface, mesh, seconds);
}
#endif

void Run(std::int64_t points, bool isReal)
{
  const Surface surface(points, isReal);
  for (const double part : { 0.01, 0.03, 0.1 })
  {
    const auto vertices = std::size_t(part * double(surface.Columns.size()));
    std::printf("\n%zu points, %s heights, %.0f %% of the points\n\n", surface.Columns.size(),
      isReal ? "real" : "whole", 100.0 * part);
    std::printf("| method | vertices | seconds | mean error | largest error |\n| --- | --- | --- | --- | --- |\n");
    RunOwn("decimation", surface, vertices, true);
    RunOwn("decimation, heights not fitted", surface, vertices, false);
    RunGreedyTerrain(surface, 2 * vertices);
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
    RunMeshoptimizer(surface, 2 * vertices);
#endif
  }
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
    sizes = { 148317, 886639 };
  }
  for (const std::int64_t size : sizes)
  {
    Run(size, true);
    Run(size, false);
  }
  return EXIT_SUCCESS;
}
