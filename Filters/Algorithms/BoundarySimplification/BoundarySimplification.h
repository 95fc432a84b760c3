// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fewer points on the boundary loops of a horizon (thesis 3.4, Alg. 3.3).
//
// A loop is split into runs that are straight in plan; the ends of a run stay. Within a run the middle one of three
// points in succession is dropped when its distance in space from the line through the other two is below a
// threshold. Passes over a run are repeated until nothing is dropped any more (one pass alone, as the pseudo-code
// reads, can drop half of the points at the most and never gives the rates the thesis reports). As runs are straight,
// the outline in plan stays exactly what it was: only heights change.
//
// A point that the loops visit more than once (a spur, a place where a patch touches itself) also ends a run: dropped
// from one visit but not from the other it would lie on an edge without being its end.
//
// Beyond the thesis, deviations can be bound, and corners dropped: outlines that run slantwise over the lattice are
// staircases, and have no runs. A corner goes when all that was dropped stays near enough to the new edge, in plan and
// in height, and no point of the horizon lies between the new edge and the two old ones (OutlineGuard.h).

#ifndef SeismicHorizonsBoundarySimplification_h
#define SeismicHorizonsBoundarySimplification_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct BoundarySimplificationOptions
{
  /// In lattice units, at least 0 (InputError otherwise); with 0 nothing is dropped.
  double DistanceThreshold = 0.4;
  /// Whether all points that a new edge spans have to be within the threshold, not just the one that goes with it.
  bool BoundDeviation = false;
  /// How far in plan, in columns, a dropped corner may be from the outline, at least 0 (InputError otherwise). With 0
  /// the outline in plan stays as it is.
  double OutlineTolerance = 0.0;
};

struct BoundarySimplification
{
  /// The loops without the points that were dropped, over the input points.
  Loops Boundary;
  /// For each point the point that stands for it: itself, or for one that was dropped the nearer end of the edge that
  /// spans it.
  std::vector<PointId> Target;
  /// The largest distance in space, in lattice units, of a dropped point to the edge that spans it.
  double Deviation = 0.0;
  /// The same in plan alone.
  double OutlineDeviation = 0.0;
};

/// `points` are all points of the horizon, in lattice units. Linear in the points; the passes over a run add a factor
/// that grows with the logarithm of its length where a run is flat, and with its length at the very worst. The first
/// point of each loop stays.
BoundarySimplification SimplifyBoundary(const std::vector<SpacePoint>& points, const Loops& boundary,
  const BoundarySimplificationOptions& options, const Monitor& monitor = Monitor());

/// With a threshold alone.
inline BoundarySimplification SimplifyBoundary(
  const std::vector<SpacePoint>& points, const Loops& boundary, double threshold, const Monitor& monitor = Monitor())
{
  BoundarySimplificationOptions options;
  options.DistanceThreshold = threshold;
  return SimplifyBoundary(points, boundary, options, monitor);
}
}

#endif
