// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the time of each method grows with the size of its input, on shapes that are hard for it: each is run on n and on
// 4 n points. Prints a Markdown table of processor seconds on one thread, and by which power of n the time grows: 1 is
// linear, 2 quadratic.
//
//   GrowthBenchmark [NAME ...]     (only the cases whose names contain one of these)

#include "BenchmarkTools.h"
#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Work = std::function<void()>;

/// A case makes its input of about so many points, and gives the work on it.
struct Case
{
  std::string Name;
  int Size;
  std::function<Work(int size)> Make;
};

Patches::Columns Square(int points, double density)
{
  Patches::Random random(7);
  const int side = int(std::sqrt(points / density));
  Patches::Columns columns;
  for (int n = 0; n < side * side; ++n)
  {
    if (random.Chance(density))
    {
      columns.push_back({ n % side, n / side });
    }
  }
  return columns;
}

Case Boundary(const std::string& name, int size, int radius, double density)
{
  return { name, size,
    [=](int points)
    {
      BoundaryOptions options;
      options.Radius = radius;
      options.KeepHoles = true;
      return [columns = Square(points, density), options]() { FindExteriorBoundary(columns, options); };
    } };
}

/// A frame of columns around nothing: its outline, and the loop of the hole, with few or no points inside.
Patches::Columns Frame(int points)
{
  const int side = points / 8;
  Patches::Columns columns;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      if (std::min({ x, y, side - 1 - x, side - 1 - y }) < 2)
      {
        columns.push_back({ x, y });
      }
    }
  }
  return columns;
}

BoundedHorizon OfColumns(const Patches::Columns& columns)
{
  return TestHorizons::MakeHorizon(columns, std::vector<double>(columns.size(), 0.0));
}

/// Two rows: two straight sides of so many points in all.
Patches::Columns Strip(int points)
{
  Patches::Columns columns;
  for (int n = 0; n < points / 2; ++n)
  {
    columns.push_back({ n, 0 });
    columns.push_back({ n, 1 });
  }
  return columns;
}

/// A band of rows that go up and down at random.
Patches::Columns RaggedBand(int points)
{
  Patches::Random random(5);
  Patches::Columns columns;
  for (int n = 0; n < points / 8; ++n)
  {
    const int first = random.Below(3);
    for (int row = first; row < first + 8; ++row)
    {
      columns.push_back({ n, row });
    }
  }
  return columns;
}

/// On heights that differ by less than the threshold.
Work FewestOutlinePoints(const Patches::Columns& columns)
{
  Patches::Random random(6);
  std::vector<double> heights(columns.size());
  std::generate(heights.begin(), heights.end(), [&random]() { return 0.4 * random.Fraction(); });
  BoundarySimplificationOptions options;
  options.Method = OutlineMethod::FewestPoints;
  options.OutlineTolerance = 2.0;
  return [horizon = TestHorizons::MakeHorizon(columns, heights), options]()
  { SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, options); };
}

Work Mesh(const BoundedHorizon& horizon)
{
  return [horizon]() { Triangulate(horizon); };
}

/// A ring whose inner points are all gone: the mesh spans it from rim to rim.
Work MeshOfOutline(int points)
{
  const BoundedHorizon frame = OfColumns(Frame(points));
  return Mesh(TestHorizons::Reduce(frame, SimplifyRough(frame, points)));
}

/// Two rows, and one point far from them.
Work MeshOfStrip(int points)
{
  Patches::Columns columns = Strip(points);
  for (int n = 2; n < points / 4; ++n)
  {
    columns.push_back({ points / 4, n });
  }
  return Mesh(OfColumns(columns));
}

Work RoughWithOneCell(int points)
{
  const BoundedHorizon horizon = OfColumns(Square(points, 0.9));
  return [horizon, cell = int(std::sqrt(points))]() { SimplifyRough(horizon, cell); };
}

/// Heights from one end of the range to the other: cells in layers, one point each.
Work ElaborateInLayers(int points)
{
  Patches::Random random(3);
  const Patches::Columns columns = Square(points, 1.0);
  std::vector<double> heights(columns.size());
  std::generate(heights.begin(), heights.end(), [&random]() { return std::floor(1e9 * random.Fraction()); });
  ElaborateOptions options;
  options.CellSize = 64;
  return [horizon = TestHorizons::MakeHorizon(columns, heights), options]() { SimplifyElaborate(horizon, options); };
}

/// A voxel for each surface.
Work ReadSurfaces(int surfaces)
{
  std::ostringstream file;
  file << "1 " << surfaces << " 4\n";
  for (int n = 0; n < surfaces; ++n)
  {
    file << "2 " << n + 1 << " 1 1 1\n";
  }
  return [text = file.str()]()
  {
    std::istringstream stream(text);
    ReadSparseMatrix(stream);
  };
}

Work DistanceOfNeedles(int points)
{
  TriangleSurface needles;
  for (PointId n = 0; n < points; n += 3)
  {
    needles.Points.emplace_back(0.0, n, 0.0);
    needles.Points.emplace_back(1e9, n + 0.5, 0.0);
    needles.Points.emplace_back(0.0, n + 1.0, 0.0);
    needles.Triangles.push_back({ n, n + 1, n + 2 });
  }
  return [needles]() { MeasureSurfaceDistance(needles, needles, SurfaceDistanceOptions()); };
}

std::vector<Case> ListCases()
{
  return { Boundary("clockwise growth, radius 3, a tenth missing", 250000, 3, 0.9),
    Boundary("clockwise growth, radius 8, a tenth missing", 250000, 8, 0.9),
    Boundary("clockwise growth, radius 8, half missing", 250000, 8, 0.5),
    Boundary("clockwise growth, radius 32, one in a hundred", 2500, 32, 0.01),
    { "fewest outline points, straight sides", 20000, [](int points) { return FewestOutlinePoints(Strip(points)); } },
    { "fewest outline points, ragged sides", 100000,
      [](int points) { return FewestOutlinePoints(RaggedBand(points)); } },
    { "triangulation, outline without inner points", 16000, MeshOfOutline },
    { "triangulation, strip with an arm", 16000, MeshOfStrip },
    { "rough simplification, one cell", 250000, RoughWithOneCell },
    { "elaborate simplification, cells in layers", 20000, ElaborateInLayers },
    { "sparse matrix, a surface for each voxel", 8000, ReadSurfaces },
    { "distance between needles", 3000, DistanceOfNeedles } };
}

void Print(const Case& method)
{
  const double one = BenchmarkTools::Time(method.Make(method.Size));
  const double four = BenchmarkTools::Time(method.Make(4 * method.Size));
  std::printf("| %s | %d | %.4f | %.4f | %.2f |\n", method.Name.c_str(), method.Size, one, four,
    std::log(four / one) / std::log(4.0));
  std::fflush(stdout);
}
}

int main(int argc, char* argv[])
{
  Detail::NumberOfThreads() = 1;
  std::printf("| method and shape | n | seconds of n | of 4 n | power of n |\n| --- | --- | --- | --- | --- |\n");
  for (const Case& method : ListCases())
  {
    const auto isNamed = [&method](const char* part) { return method.Name.find(part) != std::string::npos; };
    if (argc == 1 || std::any_of(argv + 1, argv + argc, isNamed))
    {
      Print(method);
    }
  }
  return 0;
}
