// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures how stages gain from threads, as Markdown.
//
//   ScalingBenchmark [--threads N,N...] [--stage NAME] [POINTS]...     (1,2, all stages, and 886639 points unless given)
//
// Horizons are generated. Seconds are elapsed times, the least of several runs; inside is the share of the time on one
// thread that loops over threads take, and what 16 threads gain at most is 1 / (1 - inside + inside / 16). Layers are
// between two horizons, faults on a horizon with six of them; the cube has a sample for each point asked for, times 6.

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/LinkCuts.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Filters/Algorithms/Layers/LayerPlan.h"
#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Generator/CubeGenerator.h"
#include "Generator/FaultGenerator.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
std::vector<int> Threads = { 1, 2 };
std::string OnlyStage;

using Work = std::function<void()>;

struct Timing
{
  double Seconds = 0.0;
  double Inside = 0.0;
};

Timing TimeOn(int threads, const Work& work)
{
  Detail::NumberOfThreads() = threads;
  Timing least;
  double total = 0.0;
  for (int run = 0; run == 0 || (run < 9 && total < 1.0); ++run)
  {
    Detail::SecondsInLoops() = 0.0;
    const double start = BenchmarkTools::Seconds(CLOCK_MONOTONIC);
    work();
    const double seconds = BenchmarkTools::Seconds(CLOCK_MONOTONIC) - start;
    if (run == 0 || seconds < least.Seconds)
    {
      least = { seconds, Detail::SecondsInLoops() / seconds };
    }
    total += seconds;
  }
  return least;
}

void Print(const std::string& stage, std::size_t points, const Work& work)
{
  if (!OnlyStage.empty() && OnlyStage != stage)
  {
    return;
  }
  std::printf("| %s | %zu |", stage.c_str(), points);
  double first = 0.0;
  for (const int threads : Threads)
  {
    const Timing timing = TimeOn(threads, work);
    if (first == 0.0)
    {
      first = timing.Seconds;
      std::printf(
        " %.3f | %.3f | %.1f |", timing.Seconds, timing.Inside, 1.0 / (1.0 - timing.Inside + timing.Inside / 16.0));
    }
    else
    {
      std::printf(" %.2f |", first / timing.Seconds);
    }
    std::fflush(stdout);
  }
  std::printf("\n");
}

struct Points
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Heights;

  std::size_t Size() const { return this->Columns.size(); }
  SurfacePoints ForSurface() const
  {
    SurfacePoints points;
    points.Columns = this->Columns;
    points.Height = this->Heights;
    return points;
  }
};

HorizonGeneratorOptions OptionsFor(std::int64_t points, int horizons)
{
  HorizonGeneratorOptions options;
  options.NumberOfHorizons = horizons;
  options.Size = HorizonGenerator::FindSize(options, points * horizons);
  return options;
}

Points MakePoints(const HorizonGeneratorOptions& options, int horizon)
{
  const LatticeHorizon voxels = HorizonGenerator(options).MakeHorizon(horizon);
  return { BenchmarkTools::ColumnsOf(voxels), { voxels.K.begin(), voxels.K.end() } };
}

void MeasureReading(std::int64_t size)
{
  std::stringstream file;
  HorizonGenerator(OptionsFor(size, 1)).Write(file);
  const std::string text = file.str();
  Print("read", std::size_t(size),
    [&]()
    {
      std::istringstream stream(text);
      ReadSparseMatrix(stream);
    });
}

TriangleSurface ToSurface(PlanePoints columns, const std::vector<double>& heights, const RawVector<PointId>& triangles)
{
  TriangleSurface surface;
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    surface.Points.emplace_back(columns[n].X, columns[n].Y, heights[n]);
  }
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    surface.Triangles.push_back({ triangles[corner], triangles[corner + 1], triangles[corner + 2] });
  }
  return surface;
}

void MeasureHorizon(std::int64_t size)
{
  const Points points = MakePoints(OptionsFor(size, 1), 0);
  const std::size_t count = points.Size();
  const auto mesh = [&](DecimationEffort effort)
  {
    SurfaceOptions options;
    options.Effort = effort;
    return MakeSurface(points.ForSurface(), options);
  };
  Print("surface, best", count, [&]() { mesh(DecimationEffort::Best); });
  Print("surface, fast", count, [&]() { mesh(DecimationEffort::Fast); });
  const BoundedHorizon horizon = BenchmarkTools::MakeGenerated(size);
  Print("boundary", count,
    [&]()
    {
      BoundaryOptions options;
      options.Radius = ChooseRadius(points.Columns);
      FindExteriorBoundary(points.Columns, options);
    });
  RawVector<PointId> all;
  Print("triangulation, all points", count, [&]() { all = Triangulate(horizon).Triangles; });
  if (OnlyStage.empty() || OnlyStage == "surface distance")
  {
    all = all.empty() ? Triangulate(horizon).Triangles : all;
    const TriangleSurface reference = ToSurface(points.Columns, points.Heights, all);
    const Decimation fast = mesh(DecimationEffort::Fast).Mesh;
    const TriangleSurface coarse = ToSurface(fast.Points.Plane, fast.Points.Height, fast.Triangles);
    Print("surface distance", count, [&]() { MeasureSurfaceDistance(reference, coarse); });
  }
  Print("hole filling", count,
    [&]()
    {
      HoleFillingOptions options;
      options.LargestHoleSize = std::int64_t(1) << 40;
      FillHoles(points.Columns, points.Heights, {}, options);
    });
}

void MeasureFaults(std::int64_t size)
{
  FaultGeneratorOptions options;
  options.Size = int(std::sqrt(double(size)));
  options.NumberOfFaults = 6;
  options.Throw = 12.0;
  options.AreTapered = true;
  options.HoleSize = options.Size / 5;
  const FaultedHorizon horizon = MakeFaultedHorizon(options);
  const ColumnHeights heights(horizon.Columns, horizon.Height);
  Print("faults", horizon.Columns.size(), [&]() { DetectFaults(heights, FaultDetectionOptions()); });
}

void MeasureLayers(std::int64_t size)
{
  const HorizonGeneratorOptions options = OptionsFor(size, 2);
  const std::vector<Points> horizons = { MakePoints(options, 0), MakePoints(options, 1) };
  std::vector<HorizonView> views(2);
  for (std::size_t n = 0; n < 2; ++n)
  {
    views[n].Columns = horizons[n].Columns;
    views[n].Heights = horizons[n].Heights.data();
  }
  Print("layers", horizons[0].Size(), [&]() { MakeLayers(views); });
}

void MeasureExtraction(std::int64_t size)
{
  CubeGeneratorOptions options = HardCube(5);
  const int side = int(std::sqrt(double(size) * 6.0 / 400.0));
  options.Size = { side, side, 400 };
  options.NoiseFraction = 0.2;
  const std::vector<float> traces = CubeGenerator(options).MakeTraces();
  StridedSamples<float> view;
  view.First = traces.data();
  view.Strides = { std::ptrdiff_t(options.Size[2]), std::ptrdiff_t(options.Size[2]) * side, 1 };
  const TraceCube cube = MakeTraceCube(options.Size, view);
  Print("extraction", traces.size(), [&]() { ExtractReflections(cube); });
}
}

int main(int argc, char* argv[])
{
  std::vector<std::int64_t> sizes;
  for (int n = 1; n < argc; ++n)
  {
    const std::string word = argv[n];
    if (word == "--threads" && n + 1 < argc)
    {
      Threads.clear();
      std::istringstream list(argv[++n]);
      for (std::string number; std::getline(list, number, ',');)
      {
        Threads.push_back(std::atoi(number.c_str()));
      }
    }
    else if (word == "--stage" && n + 1 < argc)
    {
      OnlyStage = argv[++n];
    }
    else
    {
      sizes.push_back(std::atoll(argv[n]));
    }
  }
  std::printf("| stage | points | seconds, %d thread | inside | 16 at most |", Threads.front());
  for (std::size_t n = 1; n < Threads.size(); ++n)
  {
    std::printf(" %d threads, times |", Threads[n]);
  }
  std::printf("\n| --- | --- | --- | --- | --- |");
  for (std::size_t n = 1; n < Threads.size(); ++n)
  {
    std::printf(" --- |");
  }
  std::printf("\n");
  for (const std::int64_t size : sizes.empty() ? std::vector<std::int64_t>{ 886639 } : sizes)
  {
    MeasureReading(size);
    MeasureHorizon(size);
    MeasureFaults(size);
    MeasureLayers(size);
    MeasureExtraction(size);
  }
  return EXIT_SUCCESS;
}
