// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simplifies seams between parts of a horizon (Surface.h), and joins the meshes of the parts along them.
//
// Vertices of both parts become one; a vertex of one part splits the edge and triangle of the other. Loops along seams
// vanish, and the rest is assembled anew, so that holes and patches are whole again. Gaps without surface on both sides
// stay open.

#ifndef SeismicHorizonsSurfaceJoin_h
#define SeismicHorizonsSurfaceJoin_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
// Simplifies the seams of a part of a horizon (Boundary/PlanarHops.h), so that neighbouring parts fit.
//
//     P  .  .  Q  .  P  .  .  .  .  P        P    nodes, kept by both parts
//     |_____________|_______________|        Q    a pin, where a loop of this part turns
//
// Nodes follow from the row alone: the fewest within a height tolerance, gap by gap. The other part does not know pins,
// so they move onto the line, where its edge can be split without changing the surface.
struct SeamPin
{
  PointId Point = NoPoint;
  double Height = 0.0; // lattice units
};

struct SeamChains
{
  Loops Boundary;
  std::vector<PointId> Kept;
  /// Each comes with the nearer kept point, in no order.
  std::vector<DroppedPoint> Dropped;
  std::vector<SeamPin> Pins;
  /// Gaps are wider than the radius, have no surface beside them, and are given by the point to their left.
  std::vector<PointId> OpenGaps;
  double Deviation = 0.0; // in space, lattice units
  double HeightDeviation = 0.0; // the same vertically
};

/// The boundary must have been found with `options`.
SeamChains SimplifySeams(PlanePoints columns, const std::vector<double>& height, const Loops& boundary,
  const BoundaryOptions& options, double heightTolerance);

struct SurfacePart
{
  std::vector<PlanePoint> Vertices; // whole columns
  std::vector<double> Height; // lattice units
  std::vector<std::int64_t> Count; // represented points, without the lower seam
  Loops Boundary;
  RawVector<PointId> Triangles; // counter-clockwise on the lattice
  SeamRows Seams;
  std::vector<PointId> OpenGaps; // vertices to the left of gaps
};

struct PartItem
{
  std::int32_t Part = 0;
  std::int32_t Item = 0;
};

struct JoinedSurface
{
  std::vector<PartItem> Sources; // by vertex: a vertex of a part
  std::vector<PlanePoint> Vertices;
  std::vector<std::int64_t> Count;
  std::vector<std::int32_t> Patch;
  RawVector<PointId> Triangles;
  std::vector<PartItem> TriangleSources; // by triangle: a triangle of a part
  /// Outlines come first, one per patch, then holes.
  Loops Boundary;
  std::size_t NumberOfPatches = 0;
  std::size_t SeamVertices = 0; // not on a loop
  /// Dropped patches represented these points.
  std::int64_t DroppedPoints = 0;
};

/// The upper seam of a part is the lower seam of the next. Throws InputError if parts do not fit. Takes near linear
/// time, and a few times the memory of the parts.
JoinedSurface JoinSurface(const std::vector<SurfacePart>& parts, std::int64_t minimumPatchSize = 1);
}

#endif
