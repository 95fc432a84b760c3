// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small bounded horizons for the tests of the stages inside the boundary.

#ifndef SeismicHorizonsTestHorizons_h
#define SeismicHorizonsTestHorizons_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Patches.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace TestHorizons
{
using namespace SeismicHorizons;

constexpr std::int32_t SubVoxelsPerColumn = 1 << 10;

/// Random heights around a gentle fold.
inline std::vector<double> MakeHeights(const Patches::Columns& columns, Patches::Random& random)
{
  std::vector<double> heights;
  for (const PlanePoint& column : columns)
  {
    heights.push_back(std::round(20.0 + 5.0 * std::sin(0.3 * column.X + 0.2 * column.Y) + random.Fraction()));
  }
  return heights;
}

inline BoundedHorizon MakeHorizon(const Patches::Columns& columns, const std::vector<double>& heights,
  const BoundaryOptions& options = BoundaryOptions())
{
  ExteriorBoundary boundary = FindExteriorBoundary(columns, options);
  BoundedHorizon horizon;
  for (const PlanePoint& column : columns)
  {
    horizon.Plane.push_back({ column.X * SubVoxelsPerColumn, column.Y * SubVoxelsPerColumn });
  }
  horizon.Height = heights;
  horizon.Patch = std::move(boundary.Patch);
  horizon.Count.assign(columns.size(), 1);
  horizon.Boundary = std::move(boundary.Boundary);
  horizon.SubVoxelsPerColumn = SubVoxelsPerColumn;
  return horizon;
}

/// The same horizon with its columns as places, as it is decimated.
inline BoundedHorizon OnColumns(BoundedHorizon horizon)
{
  for (PlanePoint& place : horizon.Plane)
  {
    place = { place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn };
  }
  horizon.SubVoxelsPerColumn = 1;
  return horizon;
}

/// A horizon whose heights are all 0.
inline BoundedHorizon MakeLevelHorizon(
  const Patches::Columns& columns, const BoundaryOptions& options = BoundaryOptions())
{
  return MakeHorizon(columns, std::vector<double>(columns.size(), 0.0), options);
}

/// The places of all points in lattice units.
inline std::vector<SpacePoint> ToSpacePoints(const BoundedHorizon& horizon)
{
  const SpacePoints points(horizon);
  std::vector<SpacePoint> places;
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    places.push_back(points[point]);
  }
  return places;
}

/// For each of so many points the one that represents it in a simplified boundary: itself, unless it was dropped.
inline std::vector<PointId> FindTargets(const BoundarySimplification& simplified, std::size_t points)
{
  std::vector<PointId> targets(points);
  std::iota(targets.begin(), targets.end(), 0);
  for (const DroppedPoint& dropped : simplified.Dropped)
  {
    targets[std::size_t(dropped.Point)] = dropped.Target;
  }
  return targets;
}

/// On columns, with dropped points that have no patch.
inline BoundedHorizon Leave(const BoundedHorizon& horizon, const BoundarySimplification& simplified)
{
  BoundedHorizon left = OnColumns(horizon);
  left.Boundary = simplified.Boundary;
  left.Dropped = simplified.Dropped;
  for (const DroppedPoint& dropped : simplified.Dropped)
  {
    left.Patch[std::size_t(dropped.Point)] = NoPatch;
  }
  return left;
}

/// The horizon without the points that were dropped from its boundary.
inline BoundedHorizon Drop(const BoundedHorizon& horizon, const BoundarySimplification& simplified)
{
  const KeptPoints kept = KeepOthers(simplified.Dropped, horizon.Plane.size());
  BoundedHorizon result;
  result.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  result.Plane = kept.Select(horizon.Plane);
  result.Height = kept.Select(horizon.Height);
  result.Patch = kept.Select(horizon.Patch);
  result.Count = kept.Select(horizon.Count);
  for (const DroppedPoint& dropped : simplified.Dropped)
  {
    const PointId target = NumberWithout(simplified.Dropped, dropped.Target);
    result.Count[std::size_t(target)] += horizon.Count[std::size_t(dropped.Point)];
  }
  result.Boundary = RenumberWithout(simplified.Dropped, simplified.Boundary);
  return result;
}

/// The horizon that a reduction makes of another one, with its sub-voxels.
inline BoundedHorizon Reduce(const BoundedHorizon& horizon, const Reduction& reduction)
{
  BoundedHorizon result;
  result.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  const std::int32_t scale = horizon.SubVoxelsPerColumn / reduction.SubVoxelsPerColumn;
  for (const PlanePoint& place : reduction.Plane)
  {
    result.Plane.push_back({ place.X * scale, place.Y * scale });
  }
  result.Height = reduction.Height;
  result.Boundary = reduction.Boundary;
  result.Count.assign(reduction.Source.size(), 0);
  for (const PointId source : reduction.Source)
  {
    result.Patch.push_back(horizon.Patch[std::size_t(source)]);
  }
  for (std::size_t point = 0; point < reduction.Target.size(); ++point)
  {
    result.Count[std::size_t(reduction.Target[point])] += horizon.Count[point];
  }
  return result;
}
}

#endif
