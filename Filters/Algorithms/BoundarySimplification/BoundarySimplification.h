// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fewer points on the boundary loops of a horizon (thesis 3.4, Alg. 3.3).
//
// A loop is split into runs that are straight in plan; the ends of a run stay. Within a run the middle one of three
// successive points is dropped when its distance in space from the line through the other two is below a threshold.
// Passes over a run are repeated until nothing is dropped any more. (One pass alone, as in the pseudo-code, drops half
// of the points at the most, and never gives the rates that the thesis reports.) As runs are straight, loops stay
// exactly what they were in plan: only heights change.
//
// A point that loops visit more than once (on a spur, or where a patch touches itself) also ends a run. Were it dropped
// from one visit and not from the other, it would lie on an edge without being one of its ends.
//
// Beyond the thesis, loops can have the fewest points within the tolerances instead (FewestPoints.h), deviations can be
// bound, and corners be dropped: loops that run slantwise over the lattice are staircases, and have no runs. A corner
// is dropped when all points that the new edge spans then are near enough to it, in plan and in height, and no other
// point lies between it and the two edges that it replaces (LoopGuard).
//
// Edges that cut corners leave points on both sides. Those that come to lie inside the new loops are no longer on the
// boundary, but stay points of the horizon: whatever is made of the inside has to keep near to them.

#ifndef SeismicHorizonsBoundarySimplification_h
#define SeismicHorizonsBoundarySimplification_h

#include "Common/ColumnIndex.h"
#include "Common/DroppedPoints.h"
#include "Common/Monitor.h"
#include "Common/SpacePoints.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
enum class OutlineMethod
{
  Threshold, // points are dropped one after the other, as long as they are near enough
  FewestPoints // as many as tolerances allow
};

struct BoundarySimplificationOptions
{
  /// In lattice units, at least 0 (InputError otherwise); with 0 nothing is dropped. For the fewest points it bounds
  /// the vertical distance of dropped points from the new edge, and with 0 points are dropped that are exactly on it.
  double DistanceThreshold = 0.4;
  /// Whether all points that a new edge spans have to be within the threshold of it vertically, not just the one that
  /// is dropped. For the fewest points they always are.
  bool BoundDeviation = false;
  /// How far in plan, in columns, a dropped point may be from the edge that spans it, at least 0 (InputError
  /// otherwise). With 0 no corners are dropped, and loops stay as they are in plan.
  double OutlineTolerance = 0.0;
  OutlineMethod Method = OutlineMethod::Threshold;
  /// Points that stay, as those do that loops visit more than once.
  std::vector<PointId> Fixed = {};
  /// Of the points, for the fewest points, where there is one already; else null.
  const ColumnIndex* Index = nullptr;
};

struct BoundarySimplification
{
  /// The loops with fewer points, over the input points.
  Loops Boundary;
  /// The points that were dropped, which lie outside the new loops or on them, each with the nearer end of the edge
  /// that spans it.
  DroppedPoints Dropped;
  /// How many of them lie outside.
  std::int64_t NumberOutside = 0;
  /// Their largest vertical distance, in lattice units, from the edge that spans them where it is nearest in plan.
  double HeightDeviation = 0.0;
  /// The largest distance in plan, in columns, of a point that is no longer on the loops from the edge that spans it.
  double OutlineDeviation = 0.0;
  /// The same in space, in lattice units.
  double Deviation = 0.0;
};

/// `points` are all points of the horizon, in lattice units; those of the loops stand on whole columns, and for the
/// fewest points places are columns. A loop begins where it did, or, when that is within a straight
/// run, at the end of the run; with the fewest points at the first of its points that stays. Linear in the points,
/// times the number of passes over a run, which grows with the logarithm of its length where a run is flat, and with
/// its length in the worst case; near linear for the fewest points.
BoundarySimplification SimplifyBoundary(const SpacePoints& points, const Loops& boundary,
  const BoundarySimplificationOptions& options, const Monitor& monitor = Monitor());

/// With a threshold alone.
inline BoundarySimplification SimplifyBoundary(
  const SpacePoints& points, const Loops& boundary, double threshold, const Monitor& monitor = Monitor())
{
  BoundarySimplificationOptions options;
  options.DistanceThreshold = threshold;
  return SimplifyBoundary(points, boundary, options, monitor);
}
}

#endif
