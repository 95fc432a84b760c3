// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Constrained Delaunay triangulation, in plan, of the inside of the boundary (thesis chapter 5).
//
// Full blocks of the lattice need no search. An advancing front meshes the rest: an edge makes a triangle with the one
// point for which this is constrained Delaunay (ThirdPointSearch.h), and the two new edges join the front, or leave it
// if their reverse is in it. Third points follow from the edge alone, by exact predicates without ties (Predicates.h),
// so that triangles fit in any order, and fronts grow in parallel (PatchFront.h). No triangle lies outside the
// boundary, so that none has to be deleted (thesis 5.3.8).

#ifndef SeismicHorizonsTriangulation_h
#define SeismicHorizonsTriangulation_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/BoundedHorizon.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// The search starts along the perpendicular bisector of the edge, or with the most compact triangle in a box (thesis
/// 5.3.4 to 5.3.6). The mesh is the same.
enum class SearchStrategy
{
  VoxelTraversal,
  Compactness
};

struct TriangulationOptions
{
  SearchStrategy Strategy = SearchStrategy::VoxelTraversal;
  /// For display: a patch stops at this number of triangles, and full blocks are searched as well; 0 means no limit.
  std::size_t MostTriangles = 0;
};

/// The corners of a search cell are in sub-voxels.
struct TracedCell
{
  PlanePoint Least;
  PlanePoint Greatest;
  int Dilatation = 0;
};

struct Triangulation
{
  /// Triangles are counter-clockwise, seen from +z on the lattice.
  RawVector<PointId> Triangles;
  /// These count edges with surface on one side. Edges are not Delaunay if each circle through their ends has a point
  /// inside.
  std::size_t BoundaryEdges = 0;
  std::size_t NonDelaunayEdges = 0;
  std::vector<TracedCell> Walk; // of the last triangle, if MostTriangles is set
};

/// Boundary edges are in the mesh, except along spurs, and other edges are locally Delaunay. Throws InputError for
/// shared places, points on or outside the boundary, and boundary edges that cross or do not close.
Triangulation Triangulate(const BoundedHorizon& horizon, const TriangulationOptions& options = TriangulationOptions(),
  const Monitor& monitor = Monitor());

// ---- Points without an outline --------------------------------------------------------------------------------------

/// The loop is clockwise from the least x, then y, and includes all places on its edges; places on one line give a loop
/// out and back. `places` must be distinct and not empty.
Loops FindConvexHull(const std::vector<PlanePoint>& places);

/// A triangle with a boundary edge beyond one of these limits is outside.
struct BoundaryLimits
{
  /// This is the angle opposite to the edge, in degrees from 0 to 180, with a resolution of 10^-7; 180 means no limit.
  double LargestAngle = 180.0;
  /// This is in plan, in lattice units; 0 means no limit.
  double LongestEdge = 0.0;
};

/// `mesh` must triangulate `hull`, one loop that passes no point twice; both are changed. Every point keeps a triangle,
/// and the mesh stays connected, with strips between separate groups of points. Delaunay edges stay Delaunay.
void RemoveOutsideTriangles(
  BoundedHorizon& hull, Triangulation& mesh, const BoundaryLimits& limits, const Monitor& monitor = Monitor());
}

#endif
