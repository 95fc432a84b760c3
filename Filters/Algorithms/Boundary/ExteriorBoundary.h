// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary of a horizon: the outline of each patch, i.e. the exterior boundary of the thesis (3.3, Def. 3.4, Alg. 3.1
// and 3.2), and on request the loops of its holes.
//
// An outline never crosses itself and surrounds its whole patch. It is the clockwise walk around the outer face of a
// plane graph of hops: for k = 1 the border following of Suzuki and Abe (1985). For k > 1, growth by distance
// (ExteriorBoundary.cxx) takes long hops only as bridges, out and back; clockwise growth (PlanarHops.h) takes every hop
// that crosses no other, which cuts bays short.
//
// The pseudo-code of the thesis stops at the first return to its start, and loses the rest of a patch that touches
// itself there; here the walk ends before it repeats its first hop. For k > 1 its hops may cross the loop, or never
// return; here they belong to a plane graph. It gives a loop to a patch inside another loop; here that patch belongs to
// the outer one, since their meshes would overlap.
//
// Time is linear in the points and in the columns of their bounding box, with a factor that grows with k beside empty
// columns. Temporary memory is 16 bytes per 64 columns of the box, 4 bytes per run of adjacent points in a row, 4 bytes
// per point for growth by distance with k > 1, and with cuts a byte per column. The walk is sequential, hence one
// thread.

#ifndef SeismicHorizonsExteriorBoundary_h
#define SeismicHorizonsExteriorBoundary_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Cracks.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "PatchSpans.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
enum class GrowthStrategy
{
  Distance = 0, // Loops follow neighbours, and longer hops where no neighbour continues.
  Clockwise = 1 // Loops take the first hop of a clockwise sweep, whatever its length.
};

struct BoundaryOptions
{
  /// This is k of the thesis, the largest hop along each axis in columns, from 1 to LargestRadius.
  int Radius = 1;
  GrowthStrategy Growth = GrowthStrategy::Clockwise;
  /// A hole is an inner face of the graph of hops with at least one column strictly inside.
  bool KeepHoles = false;
  /// The size counts columns strictly inside, islands included.
  std::int64_t SmallestHoleSize = 1;
  std::int64_t MinimumPatchSize = 1;
  /// A hole with a cut always has a loop, counter-clockwise around both cutoffs of a crack. Cuts exclude growth
  /// by distance with a radius above 1.
  const LinkCuts* Cuts = nullptr;
};

/// PlanarHops.cxx keeps the 2 k + 1 columns of a row as bits of a 128-bit number. Tables of hops take 8 k^4 bytes,
/// which is 8 MB here.
constexpr int LargestRadius = 32;

struct ExteriorBoundary
{
  /// Outlines come first, one per patch, clockwise seen from +z, then holes, counter-clockwise. A loop starts at its
  /// point of least x, then y; loops may touch but not cross. A strip one column wide is walked out and back.
  Loops Boundary;
  /// This is also the number of the outline; patches are numbered row by row from the least y. Points inside an outline
  /// belong to its patch unless they are in a hole with a loop.
  std::vector<std::int32_t> Patch;
  std::size_t NumberOfPatches = 0;
  Cracks OpenCracks;
};

/// `columns` must be distinct (InputError). The order of the points does not affect the result.
ExteriorBoundary FindExteriorBoundary(
  PlanePoints columns, const BoundaryOptions& options = BoundaryOptions(), const Monitor& monitor = Monitor());

ColumnIndex IndexForBoundary(PlanePoints columns, const BoundaryOptions& options);
ExteriorBoundary FindExteriorBoundary(
  PlanePoints columns, const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor = Monitor());

/// The same boundary without arrays by point, for horizons larger than memory.
struct RowBoundary
{
  Loops Boundary; // as in ExteriorBoundary
  PatchSpans Patches;
  std::vector<std::int64_t> PatchSizes; // number of points by patch
  std::size_t NumberOfPatches = 0;
};

/// The points of the index must be row-major, and its rim not empty. Throws InputError for cuts or a radius above 1.
RowBoundary FindExteriorBoundary(
  const ColumnIndex& index, const BoundaryOptions& options, const Monitor& monitor = Monitor());

/// Points with a patch are renumbered from 0.
KeptPoints DropPointsWithoutPatch(ExteriorBoundary& boundary);

enum class BoundaryType
{
  Exterior = 0,
  Topological4 = 1, // An empty column adjoins the point on one of its four sides.
  Topological8 = 2 // An empty column adjoins the point on a side or at a corner.
};

/// For topological boundaries, loops run through exactly the points of Topological4: a radius of 1, and all holes.
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options);

/// `boundary` must result from OptionsFor(type, ...). A point on an outline and on a hole is exterior.
std::vector<BoundaryKind> MarkBoundary(BoundaryType type, PlanePoints columns, const ExteriorBoundary& boundary);
}

#endif
