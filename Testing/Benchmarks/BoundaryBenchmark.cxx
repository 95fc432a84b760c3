// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures boundaries and their simplification on generated horizons, beside OpenCV and the alpha shapes of CGAL where
// these were found.
//
//   BoundaryBenchmark [--exterior] [POINTS]...     (148317 886639 10000000 when none is given)
//
// With --exterior, only the exterior boundary at radius 1.
//
// Prints lines "points,what,parameter,seconds,bytes per lattice cell,loops,boundary points". Seconds are those of
// the processor, the least of five runs (of one from 10 million points); bytes are the largest memory in use at a time
// beyond input and result, per column of the bounding box; -1 where that is not known. OpenCV starts from an image that
// is ready, we from the list of columns.

#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Generator/HorizonGenerator.h"
#ifdef SEISMICHORIZONS_HAS_OPENCV
#include "Tools/OpenCvContours.h"
#endif

#ifdef SEISMICHORIZONS_HAS_CGAL
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// What operator new has given out.
std::int64_t memoryNow = 0;
std::int64_t memoryPeak = 0;
}

void* operator new(std::size_t size)
{
  void* const memory = std::malloc(size);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  memoryNow += std::int64_t(malloc_usable_size(memory));
  memoryPeak = std::max(memoryPeak, memoryNow);
  return memory;
}

void operator delete(void* memory) noexcept
{
  memoryNow -= std::int64_t(malloc_usable_size(memory));
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

namespace
{
#ifdef SEISMICHORIZONS_HAS_OPENCV
// Its time for all loops grows with the square of the points; beyond this it takes minutes.
constexpr std::size_t MostPointsForAllOpenCvLoops = 20000000;
#endif

struct Measurement
{
  double Seconds = std::numeric_limits<double>::max();
  std::int64_t Bytes = 0;
  std::size_t Loops = 0;
  std::size_t BoundaryPoints = 0;
};

class Benchmark
{
public:
  explicit Benchmark(std::int64_t points)
  {
    HorizonGeneratorOptions options;
    options.NumberOfHorizons = 1;
    options.Size[2] = 64;
    options.Size = HorizonGenerator::FindSize(options, points);
    this->Cells = std::int64_t(options.Size[0]) * options.Size[1];
    const LatticeHorizon horizon = HorizonGenerator(options).MakeHorizon(0);
    for (std::size_t voxel = 0; voxel < horizon.Column.size(); ++voxel)
    {
      this->Columns.push_back({ horizon.Column[voxel].X, horizon.Column[voxel].Y });
      this->Horizon.Height.push_back(double(horizon.K[voxel]));
    }
    this->Horizon.Plane = this->Columns;
    this->Runs = points < 10000000 ? 5 : 1;
  }

  void Boundary(const char* what, int radius, GrowthStrategy growth, bool holes) const
  {
    BoundaryOptions options;
    options.Radius = radius;
    options.Growth = growth;
    options.KeepHoles = holes;
    this->Measure(what, radius,
      [&](Measurement& result)
      {
        const std::int64_t before = memoryNow;
        memoryPeak = before;
        const ExteriorBoundary boundary = FindExteriorBoundary(this->Columns, options);
        result.Bytes = memoryPeak - memoryNow;
        result.Loops = boundary.Boundary.Size();
        result.BoundaryPoints = boundary.Boundary.TotalLength();
      });
  }

  void Simplification(const char* what, double threshold, double tolerance) const
  {
    const ExteriorBoundary boundary = FindExteriorBoundary(this->Columns);
    BoundarySimplificationOptions options;
    options.DistanceThreshold = threshold;
    options.OutlineTolerance = tolerance;
    this->Measure(what, threshold,
      [&](Measurement& result)
      {
        memoryPeak = memoryNow;
        const BoundarySimplification simplified = SimplifyBoundary(this->Horizon, boundary.Boundary, options);
        result.Bytes = memoryPeak - memoryNow;
        result.Loops = simplified.Boundary.Size();
        result.BoundaryPoints = simplified.Boundary.TotalLength();
      });
  }

#ifdef SEISMICHORIZONS_HAS_OPENCV
  void OpenCv(bool exteriorOnly) const
  {
    cv::setNumThreads(1);
    const cv::Mat image = OpenCvContours::ToImage(this->Columns);
    for (const bool holes : { false, true })
    {
      if (holes && (exteriorOnly || this->Columns.size() > MostPointsForAllOpenCvLoops))
      {
        continue;
      }
      this->Measure(holes ? "opencv all loops" : "opencv exterior and labels", 1,
        [&](Measurement& result)
        {
          OpenCvContours::Contours contours;
          cv::findContours(image, contours, holes ? cv::RETR_CCOMP : cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
          cv::Mat labels;
          if (!holes)
          {
            cv::connectedComponents(image, labels, 8, CV_32S);
          }
          result.Bytes = -1;
          result.Loops = contours.size();
          for (const std::vector<cv::Point>& contour : contours)
          {
            result.BoundaryPoints += contour.size();
          }
        });
    }
  }
#endif

#ifdef SEISMICHORIZONS_HAS_CGAL
  /// The alpha shape that has a hop of the radius along both axes for an edge; its edges that have triangles on one
  /// side at most are counted as boundary points.
  void AlphaShape(int radius) const
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Triangles = CGAL::Triangulation_data_structure_2<CGAL::Alpha_shape_vertex_base_2<Kernel>,
      CGAL::Alpha_shape_face_base_2<Kernel>>;
    using Shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, Triangles>>;
    std::vector<Kernel::Point_2> places;
    for (const PlanePoint& column : this->Columns)
    {
      places.emplace_back(column.X, column.Y);
    }
    this->Measure("cgal alpha shape", radius,
      [&](Measurement& result)
      {
        const double squaredRadius = 0.5 * radius * radius * (1.0 + 1e-9);
        const Shape shape(places.begin(), places.end(), squaredRadius, Shape::GENERAL);
        result.Bytes = -1;
        result.BoundaryPoints =
          std::size_t(std::distance(shape.alpha_shape_edges_begin(), shape.alpha_shape_edges_end()));
      });
  }
#endif

private:
  template <typename Work>
  void Measure(const char* what, double parameter, Work&& work) const
  {
    Measurement best;
    for (int run = 0; run < this->Runs; ++run)
    {
      Measurement measurement;
      const std::clock_t start = std::clock();
      work(measurement);
      measurement.Seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      best = measurement.Seconds < best.Seconds ? measurement : best;
    }
    std::cout << this->Columns.size() << ',' << what << ',' << parameter << ',' << best.Seconds << ','
              << (best.Bytes < 0 ? -1.0 : double(best.Bytes) / double(this->Cells)) << ',' << best.Loops << ','
              << best.BoundaryPoints << std::endl;
  }

  std::vector<PlanePoint> Columns;
  BoundedHorizon Horizon; // places and heights
  std::int64_t Cells = 0;
  int Runs = 1;
};

void RunExterior(const Benchmark& benchmark, [[maybe_unused]] bool exteriorOnly)
{
  benchmark.Boundary("exterior", 1, GrowthStrategy::Clockwise, false);
#ifdef SEISMICHORIZONS_HAS_OPENCV
  benchmark.OpenCv(exteriorOnly);
#endif
}

void RunAll(const Benchmark& benchmark)
{
  RunExterior(benchmark, false);
  benchmark.Boundary("all loops", 1, GrowthStrategy::Clockwise, true);
#ifdef SEISMICHORIZONS_HAS_CGAL
  for (const int radius : { 1, 3 })
  {
    benchmark.AlphaShape(radius);
  }
#endif
  for (const int radius : { 2, 3, 4, 5 })
  {
    benchmark.Boundary("clockwise", radius, GrowthStrategy::Clockwise, false);
    benchmark.Boundary("distance", radius, GrowthStrategy::Distance, false);
  }
  benchmark.Boundary("clockwise all loops", 3, GrowthStrategy::Clockwise, true);
  for (const double threshold : { 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 })
  {
    benchmark.Simplification("simplification", threshold, 0.0);
  }
  benchmark.Simplification("simplification with tolerance 0.5", 0.4, 0.5);
  benchmark.Simplification("simplification with tolerance 1", 0.4, 1.0);
}
}

int main(int argc, char* argv[])
{
  std::vector<std::int64_t> sizes;
  const bool exteriorOnly = argc > 1 && std::string(argv[1]) == "--exterior";
  for (int n = exteriorOnly ? 2 : 1; n < argc; ++n)
  {
    sizes.push_back(std::atoll(argv[n]));
  }
  if (sizes.empty())
  {
    sizes = { 148317, 886639, 10000000 };
  }
  std::cout << "points,what,parameter,seconds,bytes per lattice cell,loops,boundary points\n";
  for (const std::int64_t points : sizes)
  {
    const Benchmark benchmark(points);
    if (exteriorOnly)
    {
      RunExterior(benchmark, true);
    }
    else
    {
      RunAll(benchmark);
    }
  }
  return EXIT_SUCCESS;
}
