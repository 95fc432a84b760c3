// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of every simplification of the inside.

#ifndef SeismicHorizonsReductionChecker_h
#define SeismicHorizonsReductionChecker_h

#include "Common/Horizon/PlaneGeometry.h"
#include "ExactPlane.h"
#include "TestHorizons.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

namespace ReductionChecker
{
using namespace TestHorizons;

inline std::vector<bool> FindBoundary(const Loops& boundary, std::size_t points)
{
  std::vector<bool> found(points, false);
  boundary.ForEachPoint([&](PointId point) { found[std::size_t(point)] = true; });
  return found;
}

/// Boundary points stay as they are; all others are strictly inside; no two are in one place; nothing is lost.
inline std::string CheckPoints(const BoundedHorizon& horizon, const Reduction& result)
{
  const BoundedHorizon reduced = Reduce(horizon, result);
  const std::set<PlanePoint> places(result.Plane.begin(), result.Plane.end());
  if (places.size() != result.Plane.size())
  {
    return "two points in one place";
  }
  if (std::accumulate(reduced.Count.begin(), reduced.Count.end(), std::int64_t(0)) !=
    std::accumulate(horizon.Count.begin(), horizon.Count.end(), std::int64_t(0)))
  {
    return "sum of counts";
  }
  const std::vector<bool> wasOnBoundary = FindBoundary(horizon.Boundary, horizon.Plane.size());
  const std::vector<bool> isOnBoundary = FindBoundary(result.Boundary, result.Plane.size());
  for (std::size_t point = 0; point < reduced.Plane.size(); ++point)
  {
    const std::size_t source = std::size_t(result.Source[point]);
    const bool moved = result.Plane[point] != horizon.Plane[source] || result.Height[point] != horizon.Height[source];
    const PointKind kind = result.Averaged[point] ? PointKind::Barycentre
                                                  : (isOnBoundary[point] ? PointKind::Boundary : PointKind::InputPoint);
    if (isOnBoundary[point] != wasOnBoundary[source] || (moved && !result.Averaged[point]) ||
      result.Origin[point].Kind != kind)
    {
      return "point " + std::to_string(point) + " is not what it says";
    }
    if (!isOnBoundary[point] && ExactPlane::Locate(reduced.Plane, reduced.Boundary, reduced.Plane[point]) != 1)
    {
      return "point " + std::to_string(point) + " not strictly inside";
    }
  }
  return std::count(wasOnBoundary.begin(), wasOnBoundary.end(), true) ==
      std::count(isOnBoundary.begin(), isOnBoundary.end(), true)
    ? std::string()
    : "boundary points lost";
}

/// Points are merged within cells, which begin at column (0, 0), and within patches. With `layered`, cells end upwards.
inline std::string CheckCells(
  const BoundedHorizon& horizon, const Reduction& result, std::int64_t cellSize, bool layered)
{
  const double bottom = *std::min_element(horizon.Height.begin(), horizon.Height.end());
  const std::int64_t cell = cellSize * horizon.SubVoxelsPerColumn;
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    const std::size_t target = std::size_t(result.Target[point]);
    const PlanePoint& a = horizon.Plane[point];
    const PlanePoint& b = result.Plane[target];
    const double up = std::floor((horizon.Height[point] - bottom) / double(cellSize)) -
      std::floor((result.Height[target] - bottom) / double(cellSize));
    if (a.X / cell != b.X / cell || a.Y / cell != b.Y / cell || (layered && up != 0.0) ||
      horizon.Patch[point] != horizon.Patch[std::size_t(result.Source[target])])
    {
      return "point " + std::to_string(point) + " merged beyond its cell or patch";
    }
  }
  return {};
}

inline bool IsSame(const Reduction& a, const Reduction& b)
{
  const auto sameOrigin = [](const PointOrigin& x, const PointOrigin& y)
  { return x.Ring == y.Ring && x.Level == y.Level && x.Kind == y.Kind; };
  return a.Target == b.Target && a.Source == b.Source && a.Averaged == b.Averaged && a.Plane == b.Plane &&
    a.Height == b.Height && a.Flatness == b.Flatness &&
    std::equal(a.Origin.begin(), a.Origin.end(), b.Origin.begin(), b.Origin.end(), sameOrigin);
}

/// The columns with their least corner at the origin.
inline Patches::Columns MovedToOrigin(Patches::Columns columns)
{
  const PlanePoint least = PlaneBox(columns).Least;
  for (PlanePoint& column : columns)
  {
    column = { column.X - least.X, column.Y - least.Y };
  }
  return columns;
}
}

#endif
