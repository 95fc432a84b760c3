// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExteriorBoundary.h"

#include "BorderScan.h"
#include "ClockwiseBoundary.h"
#include "Common/Parameters.h"
#include "CrackFaces.h"
#include "EmptyBands.h"
#include "PatchBridges.h"
#include "SeamGaps.h"
#include "SeamedHops.h"

#include <algorithm>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
ExteriorBoundary FollowNeighbours(const std::vector<PlanePoint>& columns, const ColumnRaster& raster,
  const BoundaryOptions& options, const Monitor& monitor)
{
  const HopVectors hops(1, raster.Width());
  return BorderScan<NeighbourHops>(columns, raster, hops, NeighbourHops(raster, hops), options).Run(monitor);
}

/// By hops to neighbours first. When these leave nothing to bridge, their boundary is the result.
ExteriorBoundary GrowByDistance(
  const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor)
{
  const ColumnRaster raster(columns, options.Radius);
  BoundaryOptions allHoles = options;
  allHoles.SmallestHoleSize = 1;
  const HopVectors hops(options.Radius, raster.Width());
  ExteriorBoundary parts = FollowNeighbours(columns, raster, allHoles, monitor.Step(0.0, 0.4));
  const PatchBridges bridges(columns, raster, hops, parts);
  monitor.Progress(0.5);
  if (bridges.IsEmpty() && options.SmallestHoleSize <= 1)
  {
    return parts;
  }
  return BorderScan<BridgedHops>(columns, raster, hops, BridgedHops(raster, hops, bridges), options)
    .Run(monitor.Step(0.5, 1.0));
}

ExteriorBoundary FindBetweenSeams(const std::vector<PlanePoint>& columns, const BoundaryOptions& options,
  const SeamPresence& seams, std::vector<CrackSide>& cracks, const Monitor& monitor)
{
  if (options.Radius > 1)
  {
    return FindClockwiseBoundary(columns, options, seams, cracks, monitor);
  }
  const ColumnRaster raster(columns);
  const HopVectors hops(1, raster.Width());
  const SeamGaps gaps(columns, raster, options, seams);
  return BorderScan<SeamedHops>(columns, raster, hops, SeamedHops(raster, hops, gaps), options).Run(monitor);
}

ExteriorBoundary Find(const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const SeamPresence& seams,
  std::vector<CrackSide>& cracks, const Monitor& monitor)
{
  if (seams.AtLeastRow || seams.AtGreatestRow)
  {
    return FindBetweenSeams(columns, options, seams, cracks, monitor);
  }
  if (options.Cuts)
  {
    return FindClockwiseBoundary(columns, options, seams, cracks, monitor);
  }
  if (options.Radius == 1)
  {
    return FollowNeighbours(columns, ColumnRaster(columns), options, monitor);
  }
  return options.Growth == GrowthStrategy::Distance ? GrowByDistance(columns, options, monitor)
                                                    : FindClockwiseBoundary(columns, options, seams, cracks, monitor);
}

void CheckCuts(const BoundaryOptions& options)
{
  if (options.Cuts && HasSeams(options.Seams))
  {
    throw InputError("cut links and a seam, expected one of them: a crack may go on beyond the seam");
  }
  if (options.Cuts && options.Growth == GrowthStrategy::Distance && options.Radius > 1)
  {
    throw InputError("cut links and growth by distance with a radius of " + std::to_string(options.Radius) +
      " columns, expected clockwise growth, or a radius of 1");
  }
}

/// Without the numbers and the loops of patches that are too small, and the loops of their holes.
ExteriorBoundary WithoutSpecks(const ExteriorBoundary& all, std::int64_t minimumSize)
{
  std::vector<std::int64_t> size(all.NumberOfPatches, 0);
  for (const std::int32_t patch : all.Patch)
  {
    ++size[std::size_t(patch)];
  }
  ExteriorBoundary result;
  std::vector<std::int32_t> number(size.size(), NoPatch);
  for (std::size_t patch = 0; patch < size.size(); ++patch)
  {
    number[patch] = size[patch] < minimumSize ? NoPatch : std::int32_t(result.NumberOfPatches++);
  }
  for (std::size_t loop = 0; loop < all.Boundary.Size(); ++loop)
  {
    if (number[std::size_t(all.Patch[std::size_t(*all.Boundary.begin(loop))])] != NoPatch)
    {
      result.Boundary.AppendLoop(all.Boundary, loop);
    }
  }
  for (const std::int32_t patch : all.Patch)
  {
    result.Patch.push_back(number[std::size_t(patch)]);
  }
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
ExteriorBoundary FindExteriorBoundary(
  const std::vector<PlanePoint>& columns, const BoundaryOptions& options, const Monitor& monitor)
{
  CheckWithin("radius", options.Radius, 1, LargestRadius, " columns");
  CheckAtLeast<std::int64_t>("smallest hole size", options.SmallestHoleSize, 1, " column");
  CheckAtLeast<std::int64_t>("minimum patch size", options.MinimumPatchSize, 1, " point");
  CheckSeams(columns, options);
  CheckCuts(options);
  const SeamPresence seams(columns, options.Seams);
  // Gaps of seams stay as wide as they are, and cuts where they are.
  const int reach = std::max(options.Radius, options.Seams.LongestEdge);
  std::vector<CrackSide> cracks;
  const auto find = [&](const std::vector<PlanePoint>& near) { return Find(near, options, seams, cracks, monitor); };
  ExteriorBoundary result = options.Cuts ? find(columns) : WithoutWideBands(columns, reach, find);
  if (options.MinimumPatchSize > 1)
  {
    result = WithoutSpecks(result, options.MinimumPatchSize);
  }
  result.OpenCracks = FindCracks(std::move(cracks), result.Boundary, result.Patch);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
KeptPoints DropPointsWithoutPatch(ExteriorBoundary& boundary)
{
  KeptPoints kept(boundary.Patch.size());
  for (std::size_t point = 0; point < boundary.Patch.size(); ++point)
  {
    if (boundary.Patch[point] != NoPatch)
    {
      kept.Append(PointId(point));
    }
  }
  if (!kept.AreAll())
  {
    const std::vector<PointId> numbers = kept.Numbers();
    boundary.Boundary = boundary.Boundary.Renumbered(numbers);
    for (Edge& mouth : boundary.OpenCracks.Mouths)
    {
      mouth = { numbers[std::size_t(mouth.From)], numbers[std::size_t(mouth.To)] };
    }
    boundary.Patch = kept.Select(boundary.Patch);
  }
  return kept;
}
}
