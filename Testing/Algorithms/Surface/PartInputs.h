// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points in the order of rows, and surfaces as texts, for tests of horizons that are meshed in parts.

#ifndef SeismicHorizonsPartInputs_h
#define SeismicHorizonsPartInputs_h

#include "Filters/Algorithms/Surface/Surface.h"
#include "Generator/HorizonGenerator.h"
#include "SurfaceInputs.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace PartInputs
{
using namespace SeismicHorizons;
using namespace SurfaceInputs;

inline Points SortedByRow(const Patches::Columns& columns, const std::vector<double>& heights)
{
  std::vector<std::pair<PlanePoint, double>> all;
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    all.emplace_back(columns[n], heights[n]);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return PrecedesByRow(a.first, b.first); });
  Points points;
  for (const auto& [column, height] : all)
  {
    points.Columns.push_back(column);
    points.Height.push_back(height);
  }
  return points;
}

/// A surface as a text, in points of all.
inline std::string Tell(const Surface& surface, const std::vector<PointId>& targets, std::int64_t dropped)
{
  std::ostringstream text;
  text.precision(17);
  const Decimation& mesh = surface.Mesh;
  for (std::size_t vertex = 0; vertex < mesh.Points.Source.size(); ++vertex)
  {
    text << mesh.Points.Source[vertex] << ' ' << mesh.Points.Plane[vertex].X << ' ' << mesh.Points.Plane[vertex].Y
         << ' ' << mesh.Points.Height[vertex] << ' ' << int(mesh.Points.Averaged[vertex]) << '\n';
  }
  for (const Loops* const loops : { &mesh.Points.Boundary, &surface.Boundary.Boundary })
  {
    loops->ForEachEdge([&](PointId from, PointId to) { text << from << ' ' << to << ' '; });
  }
  const auto tell = [&](const auto& values)
  {
    std::for_each(values.begin(), values.end(), [&](auto value) { text << value << ' '; });
    text << '\n';
  };
  tell(mesh.Triangles);
  tell(mesh.Errors);
  tell(targets);
  tell(std::vector<double>{ mesh.LargestError, mesh.MeanError, mesh.LargestEdgeError, mesh.LargestLoopError,
    surface.BoundaryDeviation, surface.OutlineDeviation, surface.OutlineHeightDeviation, double(surface.NumberOutside),
    double(mesh.NumberOfSlivers), double(surface.Boundary.NumberOfPatches), double(surface.Parameters.Radius),
    double(surface.Parameters.SmallestHoleSize), surface.Parameters.MaximumError, double(dropped) });
  return text.str();
}

inline SurfaceOptions RandomOptions(Patches::Random& random)
{
  SurfaceOptions options = Within(0.4 * (1 + random.Below(5)));
  options.Radius = 1;
  options.RowsOfPart = 2 + random.Below(12);
  return options;
}

/// The voxels of a generated horizon: holes, one of them with an island, a ragged outline, single missing voxels.
inline Points MakeGenerated(std::uint64_t seed, double dropouts)
{
  HorizonGeneratorOptions options;
  options.Seed = seed;
  options.Size = { 170, 340, 60 };
  options.NumberOfHorizons = 1;
  options.DropoutFraction = dropouts;
  const LatticeHorizon voxels = HorizonGenerator(options).MakeHorizon(0);
  Patches::Columns columns;
  std::vector<double> heights;
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    columns.push_back({ voxels.Column[n].X, voxels.Column[n].Y });
    heights.push_back(double(voxels.K[n]));
  }
  return SortedByRow(columns, heights);
}
}

#endif
