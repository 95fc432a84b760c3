// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An outline for points that have none, from the mesh of their convex hull: triangles outside are taken off, from the
// boundary inwards.

#ifndef SeismicHorizonsOutsideTriangles_h
#define SeismicHorizonsOutsideTriangles_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Triangulation.h"

namespace SeismicHorizons
{
/// What the boundary of a mesh may have. A triangle with an edge that exceeds one of the limits lies outside.
struct BoundaryLimits
{
  /// The largest angle that may face an edge, in degrees from 0 to 180, cut to 10^-7; 180 sets no limit.
  double LargestAngle = 180.0;
  /// The greatest length of an edge in plan, in lattice units; 0 sets no limit.
  double LongestEdge = 0.0;
};

/// Takes triangles outside off a mesh, one after the other: first that with the longest edge on the boundary, and of
/// equally long ones that with the greatest places. A triangle stays when the point that faces its edge is on the
/// boundary already. So every point keeps a triangle, and the mesh stays in one piece that is bounded by one loop,
/// which passes no point twice; where points lie in separate groups, strips of triangles stay between the groups.
///
/// `mesh` is the triangulation of `hull`, whose boundary is one loop that passes no point twice; a hull without
/// triangles is left alone. Both are changed: the loop becomes that of the smaller mesh. It starts at the same point,
/// and all edges of a Delaunay triangulation are Delaunay still.
///
/// Takes n log n in the triangles taken off, n in all others, and about 30 bytes per point. Throws InputError when a
/// limit is not in its range.
void RemoveOutsideTriangles(
  BoundedHorizon& hull, Triangulation& mesh, const BoundaryLimits& limits, const Monitor& monitor = Monitor());
}

#endif
