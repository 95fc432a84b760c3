// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the decimation beside other methods, for a number of vertices and for an error, as Markdown.
//
//   DecimationBenchmark [POINTS | FILE.ijz=STEP]...     (148317 886639 when none is given)
//
// POINTS are generated horizons with real and with whole heights; a file holds lines "i j z", and STEP is the z of one
// vertical index. Outlines have the fewest points within half a voxel, or within the error. Seconds are those of the
// processor, of all threads together, the least of several runs. Errors are vertical, in voxels, at all points of the
// horizon that the mesh covers; inside are those with no column without a point nearer than six columns. Peers start
// from what they need: vtkGreedyTerrainDecimation from the filled box, with heights of the nearest point of the row
// where there is none; meshoptimizer from the mesh of all points, whose outline it keeps, and of which it leaves more
// vertices than asked for: for a number the others get as many. Masked greedy insertion is ours on the bounding box in
// place of the outline.

#include "BenchmarkTools.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "InsidePoints.h"
#include "Tools/RealHorizons.h"

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
#include <filesystem>
#include <memory>
#include <numeric>
#include <string>
#include <unordered_set>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// How far from a column without a point a point is that counts as inside.
constexpr int Depth = 6;

/// A horizon by columns, its outline simplified.
struct Surface
{
  Surface(const Patches::Columns& columns, const std::vector<double>& heights, double tolerance)
    : Horizon(Straighten(TestHorizons::MakeHorizon(columns, heights), tolerance))
  {
    const std::int32_t side = this->Horizon.SubVoxelsPerColumn;
    for (const PlanePoint& place : this->Horizon.Plane)
    {
      this->Columns.push_back({ place.X / side, place.Y / side });
    }
    this->MakeRaster();
    this->IsInside = FindInside(this->Columns, Depth);
  }

  void MakeRaster()
  {
    std::vector<PointId> all(this->Columns.size());
    std::iota(all.begin(), all.end(), 0);
    const auto forEachPoint = [&all](auto&& add) { std::for_each(all.begin(), all.end(), add); };
    this->Raster = std::make_shared<HeightRaster>(forEachPoint, this->Columns, this->Horizon.Height.data());
  }

  static BoundedHorizon Straighten(const BoundedHorizon& horizon, double tolerance)
  {
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.DistanceThreshold = tolerance;
    options.OutlineTolerance = tolerance;
    return TestHorizons::Drop(horizon, SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, options));
  }

  BoundedHorizon Horizon;
  std::vector<PlanePoint> Columns;
  std::shared_ptr<const HeightRaster> Raster;
  std::vector<bool> IsInside;
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
  double inside = 0.0;
  std::unordered_set<PointId> counted; // columns where triangles meet count once
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
      [&](PointId point, double error, const std::array<double, 3>&)
      {
        largest = std::max(largest, std::abs(error));
        inside = surface.IsInside[std::size_t(point)] ? std::max(inside, std::abs(error)) : inside;
        sum += counted.insert(point).second ? std::abs(error) : 0.0;
      });
  }
  std::printf("| %s | %zu | %.3f | %.4f | %.3f | %.3f |\n", method, mesh.Vertices.size(), seconds,
    sum / double(counted.size()), inside, largest);
}

Mesh ToMesh(const Surface& surface, const Decimation& decimation)
{
  Mesh mesh;
  for (std::size_t vertex = 0; vertex < decimation.Points.Source.size(); ++vertex)
  {
    mesh.Vertices.push_back(
      { surface.Columns[std::size_t(decimation.Points.Source[vertex])], decimation.Points.Height[vertex] });
  }
  for (auto vertex = decimation.Triangles.begin(); vertex != decimation.Triangles.end(); vertex += 3)
  {
    mesh.Triangles.push_back({ std::size_t(vertex[0]), std::size_t(vertex[1]), std::size_t(vertex[2]) });
  }
  return mesh;
}

DecimationOptions AtMost(std::size_t vertices, DecimationEffort effort)
{
  DecimationOptions options;
  options.MaximumError = 0.0;
  options.MaximumNumberOfPoints = vertices;
  options.Effort = effort;
  return options;
}

/// Gives the vertices it leaves.
std::size_t RunOwn(const char* name, const Surface& surface, const DecimationOptions& options)
{
  Decimation decimation;
  const double seconds =
    BenchmarkTools::Time([&]() { decimation = Decimate(TestHorizons::OnColumns(surface.Horizon), options); });
  PrintRow(name, surface, ToMesh(surface, decimation), seconds);
  return decimation.Points.Source.size();
}

void PrintHead()
{
  std::printf("| method | vertices | seconds | mean error | largest inside | largest |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
}

/// On the bounding box, one column wider, whose corners have the mean height.
void RunMaskedGreedy(const Surface& surface, std::size_t vertices)
{
  Surface box(surface);
  const PlaneBox bounds(surface.Columns);
  const PlanePoint low{ bounds.Least.X - 1, bounds.Least.Y - 1 };
  const PlanePoint high{ bounds.Greatest.X + 1, bounds.Greatest.Y + 1 };
  BoundedHorizon& horizon = box.Horizon;
  const double sum = std::accumulate(horizon.Height.begin(), horizon.Height.end(), 0.0);
  const double mean = sum / double(horizon.Height.size());
  horizon.Boundary = Loops();
  std::fill(horizon.Patch.begin(), horizon.Patch.end(), 0);
  for (const PlanePoint& corner : { low, { low.X, high.Y }, high, { high.X, low.Y } })
  {
    horizon.Boundary.Append(PointId(horizon.Plane.size()));
    horizon.Plane.push_back({ corner.X * horizon.SubVoxelsPerColumn, corner.Y * horizon.SubVoxelsPerColumn });
    horizon.Height.push_back(mean);
    horizon.Patch.push_back(0);
    horizon.Count.push_back(1);
    box.Columns.push_back(corner);
    box.IsInside.push_back(false);
  }
  horizon.Boundary.Close();
  box.MakeRaster();
  DecimationOptions options = AtMost(vertices, DecimationEffort::Fast);
  options.Priority = DecimationPriority::LargestError;
  options.FitHeights = false;
  RunOwn("masked greedy insertion, box", box, options);
}

/// The heights of the whole box.
vtkSmartPointer<vtkImageData> FillBox(const Surface& surface)
{
  const PlaneBox box(surface.Columns);
  const int width = box.Greatest.X - box.Least.X + 1;
  const int height = box.Greatest.Y - box.Least.Y + 1;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->SetOrigin(box.Least.X, box.Least.Y, 0.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetNumberOfTuples(vtkIdType(width) * height);
  heights->FillValue(NAN);
  for (std::size_t point = 0; point < surface.Columns.size(); ++point)
  {
    const PlanePoint& column = surface.Columns[point];
    const vtkIdType place = vtkIdType(column.Y - box.Least.Y) * width + (column.X - box.Least.X);
    heights->SetValue(place, float(surface.Horizon.Height[point]));
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
    });
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
/// Gives the vertices it leaves.
std::size_t RunMeshoptimizer(const Surface& surface, std::size_t triangles)
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
    });
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
  return mesh.Vertices.size();
}
#endif

void RunNumber(const Surface& surface, double part)
{
  auto vertices = std::size_t(part * double(surface.Columns.size()));
  std::printf("\n%zu points, %g %% of the points\n\n", surface.Columns.size(), 100.0 * part);
  PrintHead();
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
  vertices = RunMeshoptimizer(surface, 2 * vertices);
#endif
  RunGreedyTerrain(surface, 2 * vertices);
  RunMaskedGreedy(surface, vertices);
  RunOwn("decimation, best", surface, AtMost(vertices, DecimationEffort::Best));
  DecimationOptions options = AtMost(vertices, DecimationEffort::Best);
  options.Priority = DecimationPriority::LargestError;
  RunOwn("decimation, best, largest errors", surface, options);
  options = AtMost(vertices, DecimationEffort::Fast);
  RunOwn("decimation, fast", surface, options);
  options.FitHeights = false;
  RunOwn("decimation, fast, heights not fitted", surface, options);
}

/// Outlines are within the error too. Peers get as many vertices as the best effort leaves.
void RunError(const Patches::Columns& columns, const std::vector<double>& heights, double error)
{
  const Surface surface(columns, heights, error);
  std::printf("\n%zu points within %g, %zu of them on outlines\n\n", surface.Columns.size(), error,
    surface.Horizon.Boundary.TotalLength());
  PrintHead();
  DecimationOptions options;
  options.MaximumError = error;
  const std::size_t vertices = RunOwn("decimation, best", surface, options);
  options.Effort = DecimationEffort::Fast;
  RunOwn("decimation, fast", surface, options);
  options.FitHeights = false;
  RunOwn("decimation, fast, heights not fitted", surface, options);
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
  RunMeshoptimizer(surface, 2 * vertices);
#endif
  RunGreedyTerrain(surface, 2 * vertices);
  RunMaskedGreedy(surface, vertices);
}

void Run(const Patches::Columns& columns, const std::vector<double>& heights)
{
  const Surface surface(columns, heights, 0.5);
  for (const double part : { 0.01, 0.03, 0.1 })
  {
    RunNumber(surface, part);
  }
  for (const double error : { 0.5, 0.75, 1.0 })
  {
    RunError(columns, heights, error);
  }
}

void RunGenerated(std::int64_t points)
{
  HorizonGeneratorOptions options;
  options.NumberOfHorizons = 1;
  options.Size = HorizonGenerator::FindSize(options, points);
  const LatticeHorizon voxels = HorizonGenerator(options).MakeHorizon(0);
  Patches::Columns columns;
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    columns.push_back({ voxels.Column[n].X, voxels.Column[n].Y });
  }
  std::printf("\nGenerated, real heights\n");
  Run(columns, std::vector<double>(voxels.RealZ.begin(), voxels.RealZ.end()));
  std::printf("\nGenerated, whole heights\n");
  Run(columns, std::vector<double>(voxels.K.begin(), voxels.K.end()));
}

void RunFile(const std::string& file, double step)
{
  std::vector<double> heights;
  const Patches::Columns columns = RealHorizons::Read(file, &heights);
  std::for_each(heights.begin(), heights.end(), [step](double& height) { height /= step; });
  std::printf("\n%s\n", std::filesystem::path(file).stem().c_str());
  Run(columns, heights);
}
}

int main(int argc, char* argv[])
{
  std::vector<std::string> all(argv + 1, argv + argc);
  if (all.empty())
  {
    all = { "148317", "886639" };
  }
  for (const std::string& one : all)
  {
    const std::size_t sign = one.find('=');
    if (sign == std::string::npos)
    {
      RunGenerated(std::atoll(one.c_str()));
    }
    else
    {
      RunFile(one.substr(0, sign), std::atof(one.substr(sign + 1).c_str()));
    }
  }
  return EXIT_SUCCESS;
}
