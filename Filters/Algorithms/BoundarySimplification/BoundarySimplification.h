// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reduces the points of boundary loops (thesis 3.4, Alg. 3.3).
//
// A loop is divided into runs that are straight in plan. Within a run, the middle one of three successive points is
// dropped if it is nearer than a threshold to the line through the other two, in space. Passes repeat until nothing is
// dropped; the single pass of the pseudo-code drops at most half of the points, which cannot give the rates in the
// thesis. Only heights change, since runs are straight. A point that loops visit more than once ends a run: dropped
// from one visit alone, it would lie on an edge without being its end.
//
// Beyond the thesis, loops can have the fewest points within tolerances (FewestPoints.h), deviations can be bounded,
// and corners can be dropped, as loops oblique to the lattice are staircases without runs. A corner is dropped if the
// points that the new edge replaces are within the tolerances, and no other point is in the way (LoopGuard).
//
// Points that new edges leave inside the loops remain points of the horizon, which later stages must approximate.
//
// Time is linear in the points, times the passes over a run: logarithmic in its length for flat runs, linear at worst.
// It is nearly linear for the fewest points.

#ifndef SeismicHorizonsBoundarySimplification_h
#define SeismicHorizonsBoundarySimplification_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/SpacePoints.h"
#include "Common/Horizon/Types.h"
#include "FewestPoints.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
enum class OutlineMethod
{
  Threshold,
  FewestPoints
};

struct BoundarySimplificationOptions
{
  /// This is in lattice units, at least 0 (InputError). For the fewest points it bounds the vertical distance of
  /// dropped points from the new edge, and 0 drops points exactly on it; otherwise 0 drops nothing.
  double DistanceThreshold = 0.4;
  /// All points under a new edge must be within the threshold vertically, instead of the dropped one alone. This always
  /// holds for the fewest points.
  bool BoundDeviation = false;
  /// A dropped point may be this far from its new edge in plan, in columns, at least 0 (InputError). With 0, corners
  /// stay.
  double OutlineTolerance = 0.0;
  OutlineMethod Method = OutlineMethod::Threshold;
  /// These points stay, like points that loops visit more than once.
  std::vector<PointId> Fixed = {};
  /// Longer edges, in columns, are divided at points that would be dropped; 0 for none.
  double LongestEdge = 0.0;
  /// This may be an existing index of the points, or null.
  const ColumnIndex* Index = nullptr;
  /// What earlier calls with the same points, boundary and tolerances found (FewestPoints.h), or null.
  KeptOfChains* Known = nullptr;
};

struct BoundarySimplification
{
  Loops Boundary;
  /// These lie outside the new loops or on them, each with the nearer end of the edge that replaces it.
  DroppedPoints Dropped;
  std::int64_t NumberOutside = 0;
  /// This is vertical, in lattice units, at the place of the edge that is nearest in plan.
  double HeightDeviation = 0.0;
  /// This is measured in plan, in columns, and includes points now inside the loops.
  double OutlineDeviation = 0.0;
  /// This is measured in space, in lattice units.
  double Deviation = 0.0;
};

/// `points` are all points, in lattice units; boundary points must have whole coordinates, and all points for the
/// fewest points. A loop may begin at a later point than before.
BoundarySimplification SimplifyBoundary(const SpacePoints& points, const Loops& boundary,
  const BoundarySimplificationOptions& options, const Monitor& monitor = Monitor());

/// The same for points that are kept, of each loop at least one: tells where the others lie. `points` may be those of the
/// boundary alone.
BoundarySimplification KeepOnly(
  const SpacePoints& points, const Loops& boundary, const std::vector<unsigned char>& isKept);

/// Calls visit(points) for each edge of simplified loops, with its ends and all points of the boundary between them.
void ForEachChain(const Loops& boundary, const Loops& simplified, std::size_t points,
  const std::function<void(const std::vector<PointId>&)>& visit);

/// Returns the points of simplified loops, and those of the boundary that divide an edge into partsOf(from, to) equal
/// parts.
std::vector<PointId> DivideEdges(const SpacePoints& points, const Loops& boundary, const Loops& simplified,
  const std::function<double(PointId, PointId)>& partsOf);

inline BoundarySimplification SimplifyBoundary(
  const SpacePoints& points, const Loops& boundary, double threshold, const Monitor& monitor = Monitor())
{
  BoundarySimplificationOptions options;
  options.DistanceThreshold = threshold;
  return SimplifyBoundary(points, boundary, options, monitor);
}
}

#endif
