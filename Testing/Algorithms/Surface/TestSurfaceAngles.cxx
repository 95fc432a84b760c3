// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slivers and fans of the best effort on faulted horizons, which have short outline edges and narrow parts.

#include "Filters/Algorithms/Surface/Surface.h"
#include "Generator/FaultGenerator.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

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
}

int TestSurfaceAngles(int, char*[])
{
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
