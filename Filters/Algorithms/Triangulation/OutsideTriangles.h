// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outline of points that have none: triangles outside are removed from the mesh of their convex hull.

#ifndef SeismicHorizonsOutsideTriangles_h
#define SeismicHorizonsOutsideTriangles_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Triangulation.h"

namespace SeismicHorizons
{
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
