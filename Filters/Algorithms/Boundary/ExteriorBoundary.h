// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The exterior boundary of each patch of a horizon (thesis 3.3, Def. 3.4, Alg. 3.1 and 3.2), and on request that of its
// holes.
//
// For any shape of patch and any k a loop is closed, hops at most k columns along each axis, never crosses itself, and
// has the whole patch on it or inside. It is the walk around the outer face of a plane graph of hops, clockwise, which
// at k = 1 is the border following of Suzuki and Abe (1985) for both rules of growth. They differ in the graph for
// k > 1: growth by distance (PatchBridges.h) only leaves the border of neighbouring columns to bridge a gap, there and
// back; clockwise growth (PlanarHops.h) takes every hop there is room for, and so straightens bays.
//
// Three things differ from the thesis's pseudo-code. It stops as soon as the walk is back at its first point, which
// cuts off the rest of a patch that only touches itself there; here the walk ends when it is about to repeat its first
// step. Its sweeps can jump over the boundary itself, or never return, for k > 1; hops in a plane graph can not. And a
// patch that lies inside the loop of another one has no loop of its own: it belongs to the outer patch, or two meshes
// would lie over each other.

#ifndef SeismicHorizonsExteriorBoundary_h
#define SeismicHorizonsExteriorBoundary_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// How a boundary goes on where there is a choice of hops.
enum class GrowthStrategy
{
  Distance = 0, // the nearest point that leads on
  Clockwise = 1 // the first hop of a clockwise sweep, whatever its length
};

struct BoundaryOptions
{
  /// The thesis's k: hops lead at most so many columns along each axis. 1 to LargestRadius.
  int Radius = 1;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  /// Whether holes have loops. A hole is an inner face of the graph of hops with at least one column strictly inside.
  bool HoleBoundaries = false;
  /// Holes with fewer columns strictly inside, islands included, have no loops.
  std::int64_t SmallestHoleSize = 1;
  /// Patches of fewer points are dropped, with all that belongs to them.
  std::int64_t MinimumPatchSize = 1;
};

/// Beyond this the tables of hops would outgrow any horizon.
constexpr int LargestRadius = 32;

/// The patch number of points in patches that were dropped.
constexpr std::int32_t NoPatch = -1;

struct ExteriorBoundary
{
  /// First one loop per patch, clockwise seen from +z. A spur of one column's width is walked out and back; a single
  /// point is a loop of one. Then one loop per hole, counter-clockwise, in the order in which rows from the least y
  /// meet them. Each loop begins at its point of least x, then least y. Loops do not cross, but may touch.
  Loops Boundary;
  /// For each point the number of its patch, which is also the number of the loop around it, or NoPatch. Patches are
  /// numbered in the order in which the rows of the lattice, from the least y, meet them. Points inside the loop of a
  /// patch belong to it unless they are inside a hole with a loop.
  std::vector<std::int32_t> Patch;
  /// How many of the loops are those of patches.
  std::size_t NumberOfPatches = 0;
};

/// `columns` holds the column of each point, no two the same (InputError). The result does not depend on the order of
/// the points. Linear in the points and in the columns of their bounding box, with a factor that grows with k in the
/// points on the border; beyond its result it needs 4 bytes per column of that box, for growth by distance with k > 1
/// also 4 per point, and some for the points on the border. Sequential: a walk can not know where it ends.
ExteriorBoundary FindExteriorBoundary(const std::vector<PlanePoint>& columns,
  const BoundaryOptions& options = BoundaryOptions(), const Monitor& monitor = Monitor());
}

#endif
