// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of meshes, checked with none of the code that makes them: of the project it uses plain data alone.
// The tests use it, and builds with SEISMICHORIZONS_CHECK_MESHES check each mesh that a method makes.

#ifndef SeismicHorizonsMeshChecker_h
#define SeismicHorizonsMeshChecker_h

#include "BoundedHorizon.h"
#include "Predicates.h" // for the type of 128 bits, and no predicate
#include "RawVector.h"
#include "Types.h"

#include <string>
#include <vector>

namespace SeismicHorizons::MeshChecker
{
using Triangles = RawVector<PointId>; // three points each

/// Whether methods check the meshes that they make. It takes longer than making them.
#ifdef SEISMICHORIZONS_CHECK_MESHES
constexpr bool IsOn = true;
#else
constexpr bool IsOn = false;
#endif

enum class Kind
{
  Delaunay,
  Any
};

/// `plane` holds the places of the points, and the boundary has the surface to its right. Triangles have points of the
/// plane and turn counter-clockwise; every edge has at most one triangle on each side; areas sum to that of the
/// boundary; all points are used; the edges with one triangle are the boundary edges with surface on one side; unless
/// any mesh will do, every other edge is locally Delaunay, where the boundary does not run along it in both directions.
///
/// So every place inside the boundary is in one triangle, and no other place in any: a path from one place to another
/// enters a triangle whenever it leaves one, but for where it crosses the boundary.
///
/// Empty when all is well, else what is wrong first, with the triangle.
std::string CheckTriangles(
  const std::vector<PlanePoint>& plane, const Loops& boundary, const Triangles& triangles, Kind kind = Kind::Delaunay);

/// That, and Euler's formula, patch by patch. Patches must be connected, with one loop around each and the others
/// around holes.
std::string CheckMesh(const BoundedHorizon& horizon, const Triangles& triangles, Kind kind = Kind::Delaunay);

/// Throws std::logic_error with what CheckTriangles finds; `method` is the one that made the mesh. To be called as
/// `if (MeshChecker::IsOn)`.
void Require(const char* method, const std::vector<PlanePoint>& plane, const Loops& boundary,
  const Triangles& triangles, Kind kind = Kind::Delaunay);

/// Twice the area of the triangle a, b, c: positive when it turns to the left.
Int128 Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// 1 when d is inside the circle of a, b and c, which turn to the left, 0 when on it, -1 when outside.
int SideOfCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);
}

#endif
