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

#ifndef SeismicHorizonsBoundarySimplification_h
#define SeismicHorizonsBoundarySimplification_h

#include "Monitor.h"
#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
struct BoundarySimplification
{
  /// The loops without the points that were dropped, over the input points.
  Loops Boundary;
  /// For each point the point that stands for it: itself, or for one that was dropped the nearer end of the edge that
  /// spans it.
  std::vector<PointId> Target;
  /// The largest distance in space, in lattice units, of a dropped point to the edge that spans it.
  double Deviation = 0.0;
};

/// `points` are in lattice units, `threshold` too (at least 0, InputError otherwise; with 0 nothing is dropped).
/// Linear in the points; the passes over a run add a factor that grows with the logarithm of its length where a run
/// is flat, and with its length at the very worst.
BoundarySimplification SimplifyBoundary(
  const std::vector<SpacePoint>& points, const Loops& boundary, double threshold, const Monitor& monitor = Monitor());
}

#endif
