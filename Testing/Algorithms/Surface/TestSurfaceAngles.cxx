// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slivers beside outlines; slivers and fans of the best effort on faulted horizons, which have short outline edges and
// narrow parts.

#include "Common/Horizon/Predicates.h"
#include "Generator/FaultGenerator.h"
#include "SurfaceInputs.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace SeismicHorizons;
using namespace SurfaceInputs;

namespace
{
Surface MakeFaulted(std::uint64_t seed, bool areHeightsWhole, double error)
{
  FaultGeneratorOptions generator;
  generator.Size = 200;
  generator.NumberOfFaults = 5;
  generator.Throw = 12.0;
  generator.AreTapered = true;
  generator.AreCrossed = true;
  generator.HoleSize = 40;
  generator.AreHeightsWhole = areHeightsWhole;
  generator.Seed = seed;
  const FaultedHorizon horizon = MakeFaultedHorizon(generator);
  LinkCuts cuts{ PlaneBox(PlanePoints(horizon.Columns)) };
  for (const TornLink& link : horizon.Torn)
  {
    link.IsNorth ? cuts.CutNorth(link.Column) : cuts.CutEast(link.Column);
  }
  SurfacePoints points;
  points.Columns = horizon.Columns;
  points.Height = horizon.Height;
  SurfaceOptions options;
  options.MaximumError = error;
  options.Cuts = &cuts;
  return MakeSurface(std::move(points), options);
}

int MostTrianglesAround(const Surface& surface)
{
  std::vector<int> around(surface.Mesh.Points.Source.size(), 0);
  for (const PointId corner : surface.Mesh.Triangles)
  {
    ++around[std::size_t(corner)];
  }
  return *std::max_element(around.begin(), around.end());
}

/// The least angle of a mesh in plan, in degrees.
double SmallestAngle(const Surface& surface)
{
  double sine = 1.0;
  for (std::size_t first = 0; first < surface.Mesh.Triangles.size(); first += 3)
  {
    const auto corner = [&](std::size_t n)
    { return surface.Mesh.Points.Plane[std::size_t(surface.Mesh.Triangles[first + n])]; };
    sine = std::min(sine, SineOfSmallestAngle(corner(0), corner(1), corner(2)));
  }
  return std::asin(sine) * 45.0 / std::atan(1.0);
}

/// A level rim around ground that takes a vertex in every column: sides of outlines that are as long as the rim would
/// leave nothing but slivers. They are kept only to get rid of those, and only as long as the number allows it.
void TestBesideSlivers()
{
  const auto rough = [](const PlanePoint& column)
  {
    const bool isRim = column.X == 0 || column.X == 79 || column.Y == 0 || column.Y == 39;
    return isRim ? 5.0 : 5.0 + 2.0 * ((column.X + column.Y) % 2) + (column.X * 7 + column.Y * 3) % 4;
  };
  const SurfaceInputs::Points points = MakePoints(Rectangle(80, 40), rough);
  SurfaceOptions options = Within(0.75);
  options.SmallestAngle = 0.0;
  options.Crossings = CrossingTolerance::Unbounded;
  const Surface before = MakeSurface(points, options);
  CHECK(before.AddedToOutlines.empty());
  CHECK_EQUAL(before.Mesh.Points.Boundary.TotalLength(), 4u);
  CHECK(SmallestAngle(before) < 2.0);
  for (const double angle : { 2.0, 5.0 })
  {
    options.SmallestAngle = angle;
    const Surface after = MakeSurface(points, options);
    CHECK_EQUAL(after.Mesh.NumberOfSlivers, 0u);
    CHECK(SmallestAngle(after) >= angle);
    CHECK(after.Mesh.LargestError <= 0.75 + 1e-9);
    CHECK_EQUAL(after.Mesh.Points.Boundary.TotalLength(), 4 + after.AddedToOutlines.size());
  }
  const auto plane = [](const PlanePoint& column) { return 1.0 + 0.5 * column.X; };
  CHECK(MakeSurface(MakePoints(Rectangle(80, 40), plane), Within(0.75)).AddedToOutlines.empty());
  const Surface strip = MakeSurface(MakePoints(Rectangle(80, 2), plane), Within(0.75));
  CHECK(strip.Mesh.NumberOfSlivers == 0 && CountTriangles(strip) < 10);
  options = AtMost(CountTriangles(before) / 2);
  CHECK(MakeSurface(points, options).Mesh.NumberOfSlivers < 20);
  CHECK_EQUAL(CountTriangles(MakeSurface(points, AtMost(2))), 2u);
}
}

int TestSurfaceAngles(int, char*[])
{
  TestBesideSlivers();
  std::size_t slivers = 0;
  std::size_t triangles = 0;
  int fans = 0;
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    for (const double error : { 0.75, 2.0, 3.0 })
    {
      const Surface surface = MakeFaulted(seed, seed % 2 == 0, error);
      slivers += surface.Mesh.NumberOfSlivers;
      triangles += surface.Mesh.Triangles.size() / 3;
      fans += MostTrianglesAround(surface) > 16 ? 1 : 0;
    }
  }
  CHECK(slivers < triangles / 350); // twice as many without points beside them
  CHECK(fans <= 1); // where neither flips nor collapses are within the error
  return Check::Result();
}
