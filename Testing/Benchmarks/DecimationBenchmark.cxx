// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the decimation beside other methods, for a number of vertices and for an error, as Markdown.
//
//   DecimationBenchmark [--numbers] [POINTS | FILE.ijz=STEP]...     (148317 886639 when none is given)
//
// POINTS are generated horizons with real and with whole heights; a file holds lines "i j z", and STEP is the z of one
// vertical index. Outlines have the fewest points within half a voxel, or within the error. Seconds are those of the
// processor, of all threads together, the least of several runs. Errors are vertical, in voxels, at all points of the
// horizon that the mesh covers; inside are those with no column without a point nearer than six columns. Folded are
// triangles that face down. Peers start from what they need: vtkGreedyTerrainDecimation from the filled box, with
// heights of the nearest point of the row where there is none; meshoptimizer and CGAL from the mesh of all points, and
// they keep its outline. As meshoptimizer leaves more vertices than asked for, the others get as many for a number.
// Masked greedy insertion is ours on the bounding box in place of the outline.
//
// Two tables of all surfaces come last, for numbers of vertices, which --numbers measures alone: CGAL beside the best
// effort; and the largest errors of one call beside a bisection of the error.

#include "BenchmarkTools.h"
#include "DecimationErrors.h"
#include "DecimationPeers.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Tools/RealHorizons.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

using namespace SeismicHorizons;
using namespace DecimationPeers;
using DecimationErrors::Errors;
using DecimationErrors::Mesh;
using DecimationErrors::Surface;

namespace
{
/// A method and what it made.
struct Row
{
  std::string Method;
  std::size_t Vertices = 0;
  double Seconds = 0.0;
  Errors Own;
};

Row PrintRow(const char* method, const Surface& surface, const Result& result)
{
  const Row row = { method, result.Mesh.Vertices.size(), result.Seconds, Measure(surface, result.Mesh) };
  std::printf("| %s | %zu | %.3f | %.4f | %.4f | %.3f | %.3f | %zu |\n", method, row.Vertices, row.Seconds,
    row.Own.Mean, row.Own.RootMeanSquare, row.Own.LargestInside, row.Own.Largest, row.Own.Folded);
  std::fflush(stdout);
  return row;
}

Mesh ToMesh(const std::vector<PlanePoint>& columns, const Decimation& decimation)
{
  Mesh mesh;
  for (std::size_t vertex = 0; vertex < decimation.Points.Source.size(); ++vertex)
  {
    const PlanePoint& column = columns[std::size_t(decimation.Points.Source[vertex])];
    mesh.Vertices.push_back({ double(column.X), double(column.Y), decimation.Points.Height[vertex] });
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

Result TimeOwn(const BoundedHorizon& horizon, const DecimationOptions& options)
{
  Decimation decimation;
  const double seconds = BenchmarkTools::Time([&]() { decimation = Decimate(horizon, options); });
  return { ToMesh(horizon.Plane, decimation), seconds };
}

Row RunOwn(const char* name, const Surface& surface, const DecimationOptions& options)
{
  return PrintRow(name, surface, TimeOwn(surface.Horizon, options));
}

void PrintHead()
{
  std::printf("| method | vertices | seconds | mean error | rms error | largest inside | largest | folded |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
}

/// On the bounding box, one column wider, whose corners have the mean height.
void RunMaskedGreedy(const Surface& surface, std::size_t vertices)
{
  const PlaneBox bounds(surface.Columns);
  const PlanePoint low{ bounds.Least.X - 1, bounds.Least.Y - 1 };
  const PlanePoint high{ bounds.Greatest.X + 1, bounds.Greatest.Y + 1 };
  BoundedHorizon box = surface.Horizon;
  const double mean = std::accumulate(box.Height.begin(), box.Height.end(), 0.0) / double(box.Height.size());
  box.Boundary = Loops();
  std::fill(box.Patch.begin(), box.Patch.end(), 0);
  for (const PlanePoint& corner : { low, { low.X, high.Y }, high, { high.X, low.Y } })
  {
    box.Boundary.Append(PointId(box.Plane.size()));
    box.Plane.push_back(corner);
    box.Height.push_back(mean);
    box.Patch.push_back(0);
    box.Count.push_back(1);
  }
  box.Boundary.Close();
  DecimationOptions options = AtMost(vertices, DecimationEffort::Fast);
  options.Priority = DecimationPriority::LargestError;
  options.FitHeights = false;
  PrintRow("masked greedy insertion, box", surface, TimeOwn(box, options));
}

// ---- A bisection of the error --------------------------------------------------------------------------------------
struct Bisection
{
  Row Best;
  int Runs = 0;
};

/// From an error that is near, to the least one that leaves the number of vertices.
Bisection Bisect(const Surface& surface, std::size_t vertices, double error)
{
  constexpr double enough = 1.002;
  constexpr double step = 1.2;
  DecimationOptions options;
  options.MaximumError = error;
  double fine = 0.0;
  double coarse = 0.0;
  Bisection bisection;
  while (fine == 0.0 || coarse == 0.0 || coarse > enough * fine)
  {
    const Result next = TimeOwn(surface.Horizon, options);
    ++bisection.Runs;
    const bool isFine = next.Mesh.Vertices.size() > vertices;
    (isFine ? fine : coarse) = options.MaximumError;
    if (!isFine)
    {
      bisection.Best = { "bisection", next.Mesh.Vertices.size(), next.Seconds, Measure(surface, next.Mesh) };
    }
    options.MaximumError = coarse == 0.0 ? step * fine : fine == 0.0 ? coarse / step : std::sqrt(fine * coarse);
  }
  return bisection;
}

// ---- Tables of all surfaces ----------------------------------------------------------------------------------------
using Cells = std::vector<std::string>;

/// A row for each surface, with the values for its numbers of vertices in one cell.
struct TableOfAll
{
  void Add(const std::string& horizon, const Cells& cells)
  {
    if (this->Rows.empty() || this->Rows.back().front() != horizon)
    {
      this->Rows.push_back({ horizon });
      this->Rows.back().insert(this->Rows.back().end(), cells.begin(), cells.end());
      return;
    }
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      this->Rows.back()[n + 1] += " / " + cells[n];
    }
  }

  void Print(const char* title, const Cells& head) const
  {
    if (this->Rows.empty())
    {
      return;
    }
    std::printf("\n%s\n\n", title);
    PrintCells(head);
    PrintCells(Cells(head.size(), "---"));
    std::for_each(this->Rows.begin(), this->Rows.end(), PrintCells);
  }

  static void PrintCells(const Cells& cells)
  {
    std::for_each(cells.begin(), cells.end(), [](const std::string& cell) { std::printf("| %s ", cell.c_str()); });
    std::puts("|");
  }

  std::vector<Cells> Rows;
};

TableOfAll BesideCgal;
TableOfAll Bisections;

std::string Format(double number)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

void CompareToCgal(const std::string& name, const Row& own, const Row& cgal)
{
  BesideCgal.Add(name,
    { std::to_string(own.Vertices), Format(cgal.Own.Mean / own.Own.Mean),
      Format(cgal.Own.RootMeanSquare / own.Own.RootMeanSquare), Format(cgal.Own.Largest / own.Own.Largest),
      Format(cgal.Seconds / own.Seconds), std::to_string(cgal.Own.Folded) });
}

void CompareToBisection(const std::string& name, const Surface& surface, std::size_t vertices, const Row& own)
{
  const Bisection bisection = Bisect(surface, vertices, own.Own.Largest);
  Bisections.Add(name,
    { std::to_string(own.Vertices), std::to_string(bisection.Best.Vertices), Format(own.Own.Largest),
      Format(own.Own.Largest / bisection.Best.Own.Largest), Format(own.Seconds / bisection.Best.Seconds),
      std::to_string(bisection.Runs) });
}

void PrintTablesOfAll()
{
  BesideCgal.Print("CGAL with bounded normal change over the best effort, for 1, 3 and 10 % of the points",
    { "horizon", "vertices", "mean error", "rms error", "largest", "seconds", "folded" });
  Bisections.Print("One call for the largest errors over the bisection of the error, for 1, 3 and 10 % of the points",
    { "horizon", "vertices", "of the bisection", "largest", "largest / bisection", "seconds / one mesh", "meshes" });
}

// ---- Horizons ------------------------------------------------------------------------------------------------------
void RunNumber(const std::string& name, const Surface& surface, double part)
{
  auto vertices = std::size_t(part * double(surface.Columns.size()));
  std::printf("\n%zu points, %g %% of the points\n\n", surface.Columns.size(), 100.0 * part);
  PrintHead();
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
  vertices = PrintRow("meshoptimizer", surface, RunMeshoptimizer(surface, 2 * vertices)).Vertices;
#endif
#ifdef SEISMICHORIZONS_HAS_CGAL
  PrintRow("CGAL, Lindstrom-Turk", surface, RunCgal(surface, vertices, false));
  const Row cgal = PrintRow("CGAL, Lindstrom-Turk, bounded normal change", surface, RunCgal(surface, vertices, true));
#endif
  PrintRow("vtkGreedyTerrainDecimation, filled box", surface, RunGreedyTerrain(surface, 2 * vertices));
  RunMaskedGreedy(surface, vertices);
  const Row best = RunOwn("decimation, best", surface, AtMost(vertices, DecimationEffort::Best));
  DecimationOptions options = AtMost(vertices, DecimationEffort::Best);
  options.Priority = DecimationPriority::LargestError;
  const Row largest = RunOwn("decimation, best, largest errors", surface, options);
  options = AtMost(vertices, DecimationEffort::Fast);
  RunOwn("decimation, fast", surface, options);
  options.FitHeights = false;
  RunOwn("decimation, fast, heights not fitted", surface, options);
#ifdef SEISMICHORIZONS_HAS_CGAL
  CompareToCgal(name, best, cgal);
#endif
  CompareToBisection(name, surface, vertices, largest);
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
  const std::size_t vertices = RunOwn("decimation, best", surface, options).Vertices;
  options.Effort = DecimationEffort::Fast;
  RunOwn("decimation, fast", surface, options);
  options.FitHeights = false;
  RunOwn("decimation, fast, heights not fitted", surface, options);
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
  PrintRow("meshoptimizer", surface, RunMeshoptimizer(surface, 2 * vertices));
#endif
  PrintRow("vtkGreedyTerrainDecimation, filled box", surface, RunGreedyTerrain(surface, 2 * vertices));
  RunMaskedGreedy(surface, vertices);
}

bool OnlyNumbers = false;

void Run(const std::string& name, const Patches::Columns& columns, const std::vector<double>& heights)
{
  std::printf("\n%s\n", name.c_str());
  const Surface surface(columns, heights, 0.5);
  for (const double part : { 0.01, 0.03, 0.1 })
  {
    RunNumber(name, surface, part);
  }
  if (OnlyNumbers)
  {
    return;
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
  const Patches::Columns columns = BenchmarkTools::ColumnsOf(voxels);
  const std::string name = "generated, " + std::to_string(columns.size()) + " points, ";
  Run(name + "real heights", columns, std::vector<double>(voxels.RealZ.begin(), voxels.RealZ.end()));
  Run(name + "whole heights", columns, std::vector<double>(voxels.K.begin(), voxels.K.end()));
}

void RunFile(const std::string& file, double step)
{
  std::vector<double> heights;
  const Patches::Columns columns = RealHorizons::Read(file, &heights);
  std::for_each(heights.begin(), heights.end(), [step](double& height) { height /= step; });
  const std::filesystem::path path(file);
  Run(path.parent_path().filename().string() + ", " + path.stem().string(), columns, heights);
}
}

int main(int argc, char* argv[])
{
  std::vector<std::string> all(argv + 1, argv + argc);
  OnlyNumbers = !all.empty() && all.front() == "--numbers";
  if (OnlyNumbers)
  {
    all.erase(all.begin());
  }
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
  PrintTablesOfAll();
  return EXIT_SUCCESS;
}
