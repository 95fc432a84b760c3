// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boundary of a horizon: the outline of each patch, which is the thesis's exterior boundary (3.3, Def. 3.4,
// Alg. 3.1 and 3.2), and on request the loops of its holes.
//
// For any shape of patch and any k, an outline is a closed loop of hops of at most k columns along each axis. It never
// crosses itself, and has the whole patch on it or inside. It is the clockwise walk around the outer face of a plane
// graph of hops. With k = 1 that is the border following of Suzuki and Abe (1985), for both rules of growth. With k > 1
// the rules differ in the graph: growth by distance (ExteriorBoundary.cxx) follows neighbouring columns, and takes a
// longer hop only to bridge a gap, there and back; clockwise growth (PlanarHops.h) takes every hop that crosses no
// other one, and so cuts bays short.
//
// Three things differ from the thesis's pseudo-code, which
//  - stops as soon as the walk is back at its first point, and so loses the rest of a patch that touches itself there:
//    here the walk ends when it is about to repeat its first hop;
//  - sweeps, for k > 1, over hops that can cross the loop, or never lead back to its first point: here a sweep takes
//    hops of the plane graph only;
//  - gives a loop to a patch inside the loop of another one: here that patch has none and belongs to the outer one, as
//    their meshes would lie over each other.
//
// A horizon can be cut along links between neighbouring columns (CutBlocks.h). The loop of a crack runs around both of
// its cutoffs, counter-clockwise as that of a hole, or is part of an outline where the crack reaches it.

#ifndef SeismicHorizonsExteriorBoundary_h
#define SeismicHorizonsExteriorBoundary_h

#include "Common/ColumnIndex.h"
#include "Common/Cracks.h"
#include "Common/DataModel.h"
#include "Common/KeptPoints.h"
#include "Common/LinkCuts.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// How a loop goes on where there is a choice of hops.
enum class GrowthStrategy
{
  Distance = 0, // by hops to neighbours, and by longer ones where only these lead on
  Clockwise = 1 // by the first hop of a clockwise sweep, whatever its length
};

/// Rows where a part of a horizon ends and another one goes on that has the same row (SeamGaps.h). No point is beyond.
struct SeamRows
{
  std::optional<std::int32_t> Lower; // the row of the least y
  std::optional<std::int32_t> Upper;
  /// Gaps of a seam, from a point to the next one, are closed up to so many columns, and up to the radius.
  int LongestEdge = 1;
};

inline bool HasSeams(const SeamRows& seams)
{
  return seams.Lower || seams.Upper;
}

struct BoundaryOptions
{
  /// The thesis's k: hops lead at most so many columns along each axis. 1 to LargestRadius.
  int Radius = 1;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  /// Whether holes have loops. A hole is an inner face of the graph of hops with at least one column strictly inside.
  bool HoleBoundaries = false;
  /// Holes with fewer columns strictly inside, islands included, have no loops.
  std::int64_t SmallestHoleSize = 1;
  /// Patches of fewer points have no number and no loops.
  std::int64_t MinimumPatchSize = 1;
  /// With a seam, holes need loops, all patches stay, and growth by distance is for a radius of 1 alone.
  SeamRows Seams;
  /// Where the horizon is cut, or null. Hops never cross cuts, and a hole that holds a cut has a loop, whatever the two
  /// options of holes: a crack is such a hole, though no column may lie inside it. With cuts there can be no seam, and
  /// growth by distance is for a radius of 1 alone.
  const LinkCuts* Cuts = nullptr;
};

/// PlanarHops.cxx keeps the columns that hops of a row can lead to, 2 k + 1 of them, in one number of 128 bits, of
/// which it can fill 65. Tables of hops take 8 k^4 bytes, which is 8 megabytes then.
constexpr int LargestRadius = 32;

/// The patch number of points in patches that are too small.
constexpr std::int32_t NoPatch = -1;

struct ExteriorBoundary
{
  /// First one loop per patch, its outline, clockwise seen from +z. A strip of one column's width is walked there and
  /// back; a single point is a loop of one point. Then one loop per hole, counter-clockwise, in the order in which the
  /// rows from the least y meet them. Each loop begins at its point of least x, then least y. Loops do not cross, but
  /// may touch themselves and each other.
  Loops Boundary;
  /// For each point the number of its patch, which is also the number of the outline around it, or NoPatch. Patches are
  /// numbered in the order in which the rows of the lattice, from the least y, meet them. Points inside the outline of
  /// a patch belong to it unless they are inside a hole with a loop.
  std::vector<std::int32_t> Patch;
  /// How many of the loops are outlines.
  std::size_t NumberOfPatches = 0;
  /// With cuts, the cracks between the loops.
  Cracks OpenCracks;
};

/// `columns` holds the column of each point, no two the same (InputError). The result does not depend on the order of
/// the points. Takes time linear in the points and in the columns of their bounding box, with a factor that grows with
/// k for the points beside empty columns. Memory beyond the result: 12 bytes per 64 columns of that box, for growth by
/// distance with k > 1 also 4 per point, and some for the points beside empty columns. On one thread, as each step of a
/// walk depends on the one before. With cuts, the box also has a byte per column, and is never narrowed where it is
/// empty.
ExteriorBoundary FindExteriorBoundary(
  PlanePoints columns, const BoundaryOptions& options = BoundaryOptions(), const Monitor& monitor = Monitor());

/// The same with an index of the columns, for a boundary that is found more than once, or followed by other methods.
ColumnIndex IndexForBoundary(PlanePoints columns, const BoundaryOptions& options);
ExteriorBoundary FindExteriorBoundary(
  PlanePoints columns, const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor = Monitor());

/// Leaves out the points without a patch. Gives those that have one; these are numbered from 0 then.
KeptPoints DropPointsWithoutPatch(ExteriorBoundary& boundary);

enum class BoundaryType
{
  Exterior = 0, // the points of the loops
  Topological4 = 1, // points with an empty column side by side
  Topological8 = 2 // points with an empty column side by side or corner to corner
};

/// The options that make loops run through all points of Topological4 and no others: a radius of 1, and all holes. For
/// Exterior they are returned as they are.
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options);

/// For each point what it is, given the boundary made with OptionsFor(type, ...). A point on an outline and on the loop
/// of a hole counts as exterior. A point with an empty column only at a corner is what the two points between them are.
std::vector<BoundaryKind> MarkBoundary(BoundaryType type, PlanePoints columns, const ExteriorBoundary& boundary);
}

#endif
