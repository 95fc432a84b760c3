// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the programs that measure have in common: clocks, memory, and horizons of a size.

#ifndef SeismicHorizonsBenchmarkTools_h
#define SeismicHorizonsBenchmarkTools_h

#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Generator/HorizonGenerator.h"
#include "Tools/TestHorizons.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace BenchmarkTools
{
inline double Seconds(clockid_t clock)
{
  timespec time;
  clock_gettime(clock, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// The least of several runs, of as many as fit into about a second, at least one.
template <typename Work>
double Time(Work&& work, clockid_t clock = CLOCK_PROCESS_CPUTIME_ID)
{
  double least = 0.0;
  double total = 0.0;
  for (int run = 0; run == 0 || (run < 9 && total < 1.0); ++run)
  {
    const double start = Seconds(clock);
    work();
    const double seconds = Seconds(clock) - start;
    least = run == 0 ? seconds : std::min(least, seconds);
    total += seconds;
  }
  return least;
}

/// A line of what Linux tells of this process, in bytes.
inline double ProcessBytes(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == name + ":")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return 1024.0 * kilobytes;
    }
  }
  return NAN;
}

/// By how much the memory grows at most, the result included.
template <typename Work>
double PeakBytes(Work&& work)
{
  malloc_trim(0);
  const double before = ProcessBytes("VmRSS");
  std::ofstream("/proc/self/clear_refs") << 5; // the peak starts anew
  work();
  return ProcessBytes("VmHWM") - before;
}

inline std::vector<SeismicHorizons::PlanePoint> ColumnsOf(const SeismicHorizons::LatticeHorizon& voxels)
{
  std::vector<SeismicHorizons::PlanePoint> columns;
  for (const auto& column : voxels.Column)
  {
    columns.push_back({ column.X, column.Y });
  }
  return columns;
}

inline SeismicHorizons::BoundedHorizon MakeGenerated(std::int64_t numberOfPoints)
{
  using namespace SeismicHorizons;
  HorizonGeneratorOptions options;
  options.NumberOfHorizons = 1;
  options.Size = HorizonGenerator::FindSize(options, numberOfPoints);
  const LatticeHorizon voxels = HorizonGenerator(options).MakeHorizon(0);
  return TestHorizons::MakeHorizon(ColumnsOf(voxels), std::vector<double>(voxels.K.begin(), voxels.K.end()));
}

/// After the boundary simplification with its default.
inline SeismicHorizons::BoundedHorizon Straighten(const SeismicHorizons::BoundedHorizon& horizon)
{
  return TestHorizons::Drop(horizon, SeismicHorizons::SimplifyBoundary(horizon, horizon.Boundary, 0.4));
}
}

#endif
