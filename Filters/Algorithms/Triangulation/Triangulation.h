// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The constrained Delaunay triangulation, in plan, of the inside of the boundary (thesis chapter 5).
//
// Where the lattice is full, triangles are there without a search (FullBlocks). Into the rest they grow from the edges
// of what is there and from the boundary: an edge of the front is joined with the one point that makes a constrained
// Delaunay triangle with it (ThirdPointSearch), and the new sides join the front, or leave it where another triangle
// waits. As each third point follows from the edge alone, by exact predicates that know no ties (Predicates.h),
// triangles fit together whatever order they are found in, and none is ever found outside: there is nothing to delete
// afterwards, as the thesis has to (5.3.8).

#ifndef SeismicHorizonsTriangulation_h
#define SeismicHorizonsTriangulation_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ThirdPointSearch.h"

#include <vector>

namespace SeismicHorizons
{
struct TriangulationOptions
{
  /// How the third point of an edge is looked for. It makes no difference to the mesh.
  SearchStrategy Strategy = SearchStrategy::VoxelTraversal;
  /// To look inside: stops when a patch has so many triangles, without the short cut of full blocks; 0 makes all.
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
  /// Boundary edges with surface on one side, and how many of them no circle without a point runs through: these are
  /// there because they were asked for.
  std::size_t BoundaryEdges = 0;
  std::size_t NonDelaunayEdges = 0;
  /// Of the last triangle, when MostTriangles is set.
  std::vector<TracedVoxel> Walk;
};

/// Every boundary edge is an edge of the mesh unless the surface lies on neither side of it (a spur, walked out and
/// back); every point inside the boundary is a vertex; every other edge is locally Delaunay.
///
/// Patches are meshed one after the other, a patch being the points and the loops with one patch number. Throws
/// InputError when two points are in one place, a point lies on or outside the boundary of its patch, or boundary
/// edges cross or leave a gap. Time is near linear in the points where their density in a patch is even.
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options = TriangulationOptions(),
  const Monitor& monitor = Monitor());
}

#endif
