// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceParts.h"

#include "BandMesher.h"
#include "Common/Base/FreeMemory.h"
#include "RankedParts.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t LeastRows = 64;
constexpr std::int64_t LeastBands = 2;

std::unordered_set<PointId> FindShared(const ExteriorBoundary& boundary)
{
  std::unordered_set<PointId> visited;
  std::unordered_set<PointId> shared;
  boundary.Boundary.ForEachPoint(
    [&](PointId point)
    {
      if (!visited.insert(point).second)
      {
        shared.insert(point);
      }
    });
  const std::vector<PointId> ofCracks = boundary.OpenCracks.PointsOfOpenEnds();
  shared.insert(ofCracks.begin(), ofCracks.end());
  return shared;
}

/// Meshes a few bands at a time.
void MeshAlone(BandMesher& mesher, std::size_t atOnce, PartAssembly& whole, const Monitor& monitor)
{
  const std::size_t bands = mesher.Cuts().NumberOfBands();
  const std::size_t step = 2 * ((atOnce + 1) / 2);
  std::size_t added = 0;
  for (std::size_t first = 0; first < bands; first += step)
  {
    const std::size_t end = std::min(first + step, bands);
    const auto part = [&](double done) { return (double(first) + done * double(end - first)) / double(bands); };
    mesher.MeshBands(first, end, monitor.Step(part(0.0), part(0.8)));
    mesher.MeshStrips(first, end, monitor.Step(part(0.8), part(0.9)));
    mesher.MeshStrips(first == 0 ? 1 : first - 1, end, monitor.Step(part(0.9), part(1.0)));
    mesher.Improve(end, monitor);
    for (; added < mesher.CompleteBefore(end); ++added)
    {
      whole.Add(std::exchange(mesher.Band(added), SurfacePart()));
    }
    ReturnFreeMemory();
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t RowsOfBand(const PlaneBox& box)
{
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  return std::int32_t(std::max(LeastRows, (ColumnsOfBand + width - 1) / width));
}

//----------------------------------------------------------------------------------------------------------------------
std::int32_t RowsOfPart(const PlaneBox& box, const SurfaceOptions& options, int radius)
{
  const bool isImproved = options.Effort == DecimationEffort::Best && options.EdgeLength == 0.0 &&
    options.MaximumNumberOfTriangles == 0 && options.MaximumError > 0.0;
  if (box.IsEmpty() || radius > 1 || !isImproved)
  {
    return 0;
  }
  if (options.RowsOfPart > 0)
  {
    return options.RowsOfPart;
  }
  const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
  const std::int32_t rows = RowsOfBand(box);
  return height >= LeastBands * rows ? rows : 0;
}

//----------------------------------------------------------------------------------------------------------------------
void MakeInParts(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& surface,
  const TakeTargets& take, const Monitor& monitor)
{
  SurfaceOptions ofParts = options;
  ofParts.Radius = surface.Parameters.Radius;
  const std::unordered_set<PointId> shared = FindShared(surface.Boundary);
  PartAssembly whole(rows, ofParts, surface);
  BandMesher mesher(rows, rowsOfPart, ofParts, surface.Parameters, surface.Boundary.Boundary, shared,
    [&whole](const PointWindow& window, PointId first, PointId last) { whole.AddHeights(window, first, last); });
  if (options.Ranks && options.Ranks->Size() > 1)
  {
    const PlaneBox box = rows.Box();
    const PointWindow all = rows.Read(box.Least.Y, box.Greatest.Y);
    whole.AddHeights(all, all.First, all.First + PointId(all.Columns.size()));
    MeshOnRanks(mesher, rows, rowsOfPart, ofParts, surface.Parameters, surface.Boundary.Boundary, shared,
      *options.Ranks, monitor.Step(0.0, 0.9));
    for (std::size_t band = 0; band < mesher.Cuts().NumberOfBands(); ++band)
    {
      whole.Add(mesher.Band(band));
    }
  }
  else
  {
    MeshAlone(mesher, rows.MostAtOnce(), whole, monitor.Step(0.0, 0.9));
  }
  whole.Finish(take, monitor.Step(0.9, 1.0));
}
}
