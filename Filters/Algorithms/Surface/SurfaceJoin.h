// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One mesh out of those of the parts of a horizon, which share the rows of their seams (SeamChains.h).
//
// Vertices of a seam that both parts have become one. Where only one part has a vertex, it stands on an edge of the
// other one, which is cut there, and its triangle with it. Loops along a seam end: with the outside on their left they
// only went there because the part did. What is left of all loops is put together anew, so that holes and patches that
// the seams cut are whole again. A gap of a seam without surface on both sides is open again.

#ifndef SeismicHorizonsSurfaceJoin_h
#define SeismicHorizonsSurfaceJoin_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The mesh of a part of a horizon.
struct SurfacePart
{
  std::vector<PlanePoint> Vertices; // whole columns
  std::vector<double> Height; // lattice units
  std::vector<std::int64_t> Count; // how many points each vertex represents, those on the lower seam aside
  Loops Boundary;
  RawVector<PointId> Triangles; // counter-clockwise on the lattice
  SeamRows Seams;
  std::vector<PointId> OpenGaps; // the vertices to the left of these
};

/// A vertex or a triangle of a part.
struct PartItem
{
  std::int32_t Part = 0;
  std::int32_t Item = 0;
};

struct JoinedSurface
{
  /// For each vertex one that it was, and its column.
  std::vector<PartItem> Sources;
  std::vector<PlanePoint> Vertices;
  std::vector<std::int64_t> Count;
  std::vector<std::int32_t> Patch;
  RawVector<PointId> Triangles;
  /// For each triangle the one that it is, or is a piece of.
  std::vector<PartItem> TriangleSources;
  /// First an outline for each patch, then the loops of holes.
  Loops Boundary;
  std::size_t NumberOfPatches = 0;
  /// How many vertices of seams are not on a loop.
  std::size_t SeamVertices = 0;
  /// How many points patches stood for that were left out as too small.
  std::int64_t DroppedPoints = 0;
};

/// The parts come in the order of their rows, the upper seam of each is the lower one of the next. Patches of fewer
/// points are left out. Throws InputError when parts do not fit. Near linear; needs a few times the memory of the
/// parts.
JoinedSurface JoinSurface(const std::vector<SurfacePart>& parts, std::int64_t minimumPatchSize = 1);
}

#endif
