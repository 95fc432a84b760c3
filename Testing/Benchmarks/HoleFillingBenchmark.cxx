// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long it takes to fill holes: single ones of up to a million columns, and many in ten million columns of which one
// in a hundred is missing. Prints a Markdown table of processor seconds on one thread, and of seconds on two. Threads
// share small holes only.
//
//   HoleFillingBenchmark

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/HoleFilling/HoleFilling.h"
#include "Tools/Patches.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
struct Lattice
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Heights;
};

/// Noise on folds, in a square without the columns that are marked.
Lattice WithoutMarked(int side, const std::vector<bool>& isHole)
{
  Patches::Random random(1);
  Lattice lattice;
  for (std::int32_t n = 0; n < side * side; ++n)
  {
    const std::int32_t x = n % side;
    const std::int32_t y = n / side;
    if (!isHole[std::size_t(n)])
    {
      lattice.Columns.push_back({ x, y });
      lattice.Heights.push_back(10.0 * std::sin(0.01 * x) + 7.0 * std::cos(0.013 * y) + random.Fraction());
    }
  }
  return lattice;
}

Lattice OneHole(int width)
{
  const int side = width + 20;
  std::vector<bool> isHole(std::size_t(side * side), false);
  for (int n = 0; n < width * width; ++n)
  {
    isHole[std::size_t((10 + n / width) * side + 10 + n % width)] = true;
  }
  return WithoutMarked(side, isHole);
}

/// Square holes at random places, which may overlap.
Lattice ManyHoles(int width)
{
  const int side = 3162;
  Patches::Random random(2);
  std::vector<bool> isHole(std::size_t(side * side), false);
  for (std::int64_t missing = 0; missing < std::int64_t(side) * side / 100;)
  {
    const int x = 6 + random.Below(side - 12 - width);
    const int y = 6 + random.Below(side - 12 - width);
    for (int n = 0; n < width * width; ++n)
    {
      const std::size_t place = std::size_t((y + n / width) * side + x + n % width);
      missing += isHole[place] ? 0 : 1;
      isHole[place] = true;
    }
  }
  return WithoutMarked(side, isHole);
}

void Measure(const std::string& name, const Lattice& lattice)
{
  std::printf("| %s |", name.c_str());
  for (const FillMethod method : { FillMethod::Plate, FillMethod::Membrane })
  {
    HoleFillingOptions options;
    options.LargestHoleSize = std::int64_t(1) << 40;
    options.Method = method;
    const auto fill = [&]() { FillHoles(lattice.Columns, lattice.Heights, {}, options); };
    Detail::NumberOfThreads() = 1;
    std::printf(" %.3g |", BenchmarkTools::Time(fill));
    Detail::NumberOfThreads() = 2;
    std::printf(" %.3g |", BenchmarkTools::Time(fill, CLOCK_MONOTONIC));
  }
  std::printf("\n");
  std::fflush(stdout);
}
}

int main()
{
  std::printf("| holes | plate | two threads | membrane | two threads |\n| --- | --- | --- | --- | --- |\n");
  for (const int width : { 10, 30, 100, 300, 1000 })
  {
    Measure("one of " + std::to_string(width) + " x " + std::to_string(width), OneHole(width));
  }
  for (const int width : { 1, 3, 10, 30 })
  {
    Measure(
      "10 million columns, 1 % in holes of " + std::to_string(width) + " x " + std::to_string(width), ManyHoles(width));
  }
  return 0;
}
