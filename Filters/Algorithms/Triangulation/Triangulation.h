// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The constrained Delaunay triangulation, in plan, of the inside of the boundary (thesis chapter 5).
//
// Where the lattice is full, triangles need no search (FullBlocks). The rest is meshed from the edges of these
// triangles and from the boundary, by an advancing front of edges that wait for a triangle. An edge of the front makes
// a triangle with the one point for which this is constrained Delaunay (ThirdPointSearch). The two new sides join the
// front; one that is in it already, in the other direction, leaves it. As each third point follows from the edge alone,
// by exact predicates without ties (Predicates.h), triangles fit together in whatever order they are found, and fronts
// grow side by side in strips of a patch (PatchFront.h). None is ever found outside the boundary, so that there is
// nothing to delete afterwards (thesis 5.3.8).

#ifndef SeismicHorizonsTriangulation_h
#define SeismicHorizonsTriangulation_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// How the third point of an edge is looked for (thesis 5.3.4 to 5.3.6): first in the voxels along its perpendicular
/// bisector, or for the most compact triangle in a box. The mesh is the same.
enum class SearchStrategy
{
  VoxelTraversal,
  Compactness
};

struct TriangulationOptions
{
  SearchStrategy Strategy = SearchStrategy::VoxelTraversal;
  /// To show how the mesh grows: stops when a patch has so many triangles, and searches for all of them, those of full
  /// blocks too; 0 makes all.
  std::size_t MostTriangles = 0;
};

/// A voxel that the search for the last triangle looked into, as a square in sub-voxels.
struct TracedVoxel
{
  PlanePoint Least;
  PlanePoint Greatest;
  int Dilatation = 0; // as in WalkedVoxel
};

struct Triangulation
{
  /// Three points per triangle, counter-clockwise seen from +z on the lattice.
  RawVector<PointId> Triangles;
  /// Boundary edges with surface on one side, and how many of them are not Delaunay: no circle through their ends is
  /// without a point. Those are in the mesh only because the boundary has them.
  std::size_t BoundaryEdges = 0;
  std::size_t NonDelaunayEdges = 0;
  /// Of the last triangle, when MostTriangles is set.
  std::vector<TracedVoxel> Walk;
};

/// Every boundary edge is an edge of the mesh unless the surface lies on neither side of it (a spur, walked out and
/// back); every point inside the boundary is a vertex; every other edge is locally Delaunay.
///
/// Patches are meshed one after the other, a patch being the points and the loops with one patch number. The order of
/// the triangles depends on the points alone, and not on the number of threads. Throws InputError when two points are
/// in one place, a point lies on or outside the boundary of its patch, or boundary edges cross or leave a gap. Time is
/// near linear in the points where their density in a patch is even.
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options = TriangulationOptions(),
  const Monitor& monitor = Monitor());
}

#endif
