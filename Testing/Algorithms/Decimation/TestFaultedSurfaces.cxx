// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much nearer meshes are to a faulted surface that is cut along its fault, with no more vertices: a dipping fold,
// and a bent fault across the lattice with tips inside, whose throw falls from 15 in the middle to less than 1.

#include "Common/Horizon/PlaneGeometry.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/Check.h"
#include "Tools/ExactPlane.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>

using namespace TestHorizons;

namespace
{
constexpr std::int32_t Width = 160;
constexpr std::int32_t Height = 120;
constexpr double GreatestThrow = 15.0;
constexpr double LeastThrow = 1.0; // of faulted links

/// Where the fault crosses a column of the lattice, and the throw there.
double FaultAt(std::int32_t x)
{
  return 30.3 + 0.35 * x + 6.0 * std::sin(0.06 * x);
}

double ThrowAt(std::int32_t x)
{
  const double part = (x - 80.0) / 52.0;
  return std::abs(part) < 1.0 ? GreatestThrow * (1.0 - part * part) : 0.0;
}

double HeightAt(const PlanePoint& column)
{
  const double fold = 60.0 + 0.2 * column.X + 0.1 * column.Y + 8.0 * std::sin(0.05 * column.X + 0.03 * column.Y);
  return fold + (column.Y > FaultAt(column.X) ? ThrowAt(column.X) : 0.0);
}

/// A link is cut where the fault runs through it.
LinkCuts FindFault(const Patches::Columns& columns)
{
  const auto isAbove = [](std::int32_t x, std::int32_t y) { return y > FaultAt(x); };
  LinkCuts cuts{ PlaneBox(columns) };
  for (const PlanePoint& column : columns)
  {
    const bool isThrown = ThrowAt(column.X) >= LeastThrow;
    if (isThrown && isAbove(column.X, column.Y + 1) && !isAbove(column.X, column.Y))
    {
      cuts.CutNorth(column);
    }
    if (isThrown && isAbove(column.X, column.Y) != isAbove(column.X + 1, column.Y) &&
      ThrowAt(column.X + 1) >= LeastThrow)
    {
      cuts.CutEast(column);
    }
  }
  return cuts;
}

/// The surface with its outlines simplified, cut or not.
BoundedHorizon MakeSurface(bool isCut, const BoundarySimplificationOptions& outlines)
{
  Patches::Columns columns;
  std::vector<double> heights;
  for (std::int32_t n = 0; n < Width * Height; ++n)
  {
    columns.push_back({ n % Width, n / Width });
    heights.push_back(HeightAt(columns.back()));
  }
  const LinkCuts cuts = FindFault(columns);
  BoundaryOptions options;
  options.Cuts = isCut ? &cuts : nullptr;
  const BoundedHorizon horizon = MakeHorizon(columns, heights, options);
  BoundedHorizon result = Drop(horizon, SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, outlines));
  result.Cuts = isCut ? std::make_shared<const LinkCuts>(cuts) : nullptr;
  return result;
}

/// The largest vertical distance of the surface from a mesh, at the columns that the mesh covers.
double LargestError(const BoundedHorizon& mesh)
{
  double largest = 0.0;
  const RawVector<PointId> triangles = Triangulate(mesh).Triangles;
  for (std::size_t n = 0; n < triangles.size(); n += 3)
  {
    const PointId* const corners = triangles.data() + n;
    const auto at = [&](int corner) { return mesh.Plane[std::size_t(corners[corner])]; };
    const PlaneBox box({ at(0), at(1), at(2) });
    for (std::int32_t y = (box.Least.Y + SubVoxelsPerColumn - 1) / SubVoxelsPerColumn;
         y <= box.Greatest.Y / SubVoxelsPerColumn; ++y)
    {
      for (std::int32_t x = (box.Least.X + SubVoxelsPerColumn - 1) / SubVoxelsPerColumn;
           x <= box.Greatest.X / SubVoxelsPerColumn; ++x)
      {
        const PlanePoint place{ x * SubVoxelsPerColumn, y * SubVoxelsPerColumn };
        const double a = double(ExactPlane::Turn(at(1), at(2), place));
        const double b = double(ExactPlane::Turn(at(2), at(0), place));
        const double c = double(ExactPlane::Turn(at(0), at(1), place));
        if (a >= 0.0 && b >= 0.0 && c >= 0.0)
        {
          const auto height = [&](int corner) { return mesh.Height[std::size_t(corners[corner])]; };
          const double here = (a * height(0) + b * height(1) + c * height(2)) / (a + b + c);
          largest = std::max(largest, std::abs(here - HeightAt({ x, y })));
        }
      }
    }
  }
  return largest;
}

void Compare(const char* method, std::size_t vertices, double with, std::size_t verticesWithout, double without)
{
  std::cout << method << ": " << with << " with " << vertices << " vertices, without cuts " << without << " with "
            << verticesWithout << '\n';
  CHECK(4.0 * with <= without);
}

/// Without cuts, cells are as small as gives no fewer vertices.
void CompareCells(
  const char* method, int cellSize, const std::function<Reduction(const BoundedHorizon&, int)>& simplify)
{
  const BoundarySimplificationOptions straight;
  const BoundedHorizon cut = MakeSurface(true, straight);
  const BoundedHorizon mesh = Reduce(cut, simplify(cut, cellSize));
  const BoundedHorizon whole = MakeSurface(false, straight);
  BoundedHorizon meshOfWhole = Reduce(whole, simplify(whole, cellSize));
  while (meshOfWhole.Plane.size() < mesh.Plane.size())
  {
    meshOfWhole = Reduce(whole, simplify(whole, --cellSize));
  }
  CHECK(meshOfWhole.Plane.size() >= mesh.Plane.size());
  Compare(method, mesh.Plane.size(), LargestError(mesh), meshOfWhole.Plane.size(), LargestError(meshOfWhole));
}

/// As many points as the mesh with cuts may have; outlines may be as far off sideways as the mesh in height.
void CompareErrorBounded()
{
  constexpr double Error = 0.75;
  BoundarySimplificationOptions outlines;
  outlines.Method = OutlineMethod::FewestPoints;
  outlines.OutlineTolerance = Error;
  outlines.DistanceThreshold = Error;
  DecimationOptions options;
  options.MaximumError = Error;
  const BoundedHorizon cut = OnColumns(MakeSurface(true, outlines));
  const Decimation mesh = Decimate(cut, options);
  std::cout << "sides: " << mesh.LargestEdgeError << ", of loops: " << mesh.LargestLoopError << '\n';
  CHECK(mesh.LargestEdgeError <= Error + 1e-9);
  CHECK(mesh.LargestLoopError < LeastThrow);
  for (const DecimationPriority priority : { DecimationPriority::LargestError, DecimationPriority::SumOfSquares })
  {
    options.MaximumError = 0.0; // not the target
    options.MaximumNumberOfPoints = mesh.Points.Source.size();
    options.Priority = priority;
    const Decimation whole = Decimate(OnColumns(MakeSurface(false, outlines)), options);
    Compare(
      "error-bounded", mesh.Points.Source.size(), mesh.LargestError, whole.Points.Source.size(), whole.LargestError);
  }
}
}

int TestFaultedSurfaces(int, char*[])
{
  CompareCells("rough", 8, [](const BoundedHorizon& horizon, int size) { return SimplifyRough(horizon, size); });
  CompareCells(
    "elaborate", 8, [](const BoundedHorizon& horizon, int size) { return SimplifyElaborate(horizon, size); });
  CompareErrorBounded();
  return Check::Result();
}
