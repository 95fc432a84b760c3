// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outline of points that have none: triangles outside are removed from the mesh of their convex hull.

#ifndef SeismicHorizonsOutsideTriangles_h
#define SeismicHorizonsOutsideTriangles_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/Types.h"
#include "Triangulation.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
// The convex hull serves as the outline of points that have none (Andrew, "Another efficient algorithm for convex hulls
// in two dimensions", 1979).

namespace Detail
{
/// The chain turns only right, with all other points on it or to its right.
template <typename Iterator>
std::vector<PointId> MakeHullChain(Iterator first, Iterator last, const std::vector<PlanePoint>& places)
{
  std::vector<PointId> chain;
  for (; first != last; ++first)
  {
    while (chain.size() > 1 && SignedArea(places[chain[chain.size() - 2]], places[chain.back()], places[*first]) > 0)
    {
      chain.pop_back();
    }
    chain.push_back(*first);
  }
  return chain;
}
}

/// The loop is clockwise from the least x, then y, and includes all places on its edges; places on one line give a loop
/// out and back. `places` must be distinct and not empty.
inline Loops FindConvexHull(const std::vector<PlanePoint>& places)
{
  assert(!places.empty());
  std::vector<PointId> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&places](PointId a, PointId b) { return places[a] < places[b]; });
  const std::vector<PointId> upper = Detail::MakeHullChain(order.begin(), order.end(), places);
  const std::vector<PointId> lower = Detail::MakeHullChain(order.rbegin(), order.rend(), places);
  Loops hull;
  std::for_each(upper.begin(), upper.end(), [&hull](PointId point) { hull.Append(point); });
  for (std::size_t n = 1; n + 1 < lower.size(); ++n)
  {
    hull.Append(lower[n]);
  }
  hull.Close();
  return hull;
}

/// A triangle with a boundary edge beyond one of these limits is outside.
struct BoundaryLimits
{
  /// This is the angle opposite to the edge, in degrees from 0 to 180, with a resolution of 10^-7; 180 means no limit.
  double LargestAngle = 180.0;
  /// This is in plan, in lattice units; 0 means no limit.
  double LongestEdge = 0.0;
};

/// `mesh` must triangulate `hull`, one loop that passes no point twice; both are changed. Every point keeps a triangle,
/// and the mesh stays connected, with strips between separate groups of points. Delaunay edges stay Delaunay.
void RemoveOutsideTriangles(
  BoundedHorizon& hull, Triangulation& mesh, const BoundaryLimits& limits, const Monitor& monitor = Monitor());
}

#endif
