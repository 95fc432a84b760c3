// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks meshes independently of the code that makes them. Tests use it, and builds with SEISMICHORIZONS_CHECK_MESHES
// check all meshes.
//
// CheckTriangles requires that triangles are counterclockwise; an edge has at most one triangle on each side; areas sum
// to the area of the boundary; all points are used; edges with one triangle are boundary edges with surface on one
// side; and for Kind::Delaunay other edges are locally Delaunay, unless the boundary runs along them in both
// directions. So every place inside the boundary is in one triangle, and no other place is in any: a path that leaves a
// triangle enters another one, except across the boundary.

#ifndef SeismicHorizonsMeshChecker_h
#define SeismicHorizonsMeshChecker_h

#include "BoundedHorizon.h"
#include "Common/Base/RawVector.h"
#include "Predicates.h" // for the type of 128 bits, and no predicate
#include "Types.h"

#include <string>
#include <vector>

namespace SeismicHorizons::MeshChecker
{
using Triangles = RawVector<PointId>;

/// Checking takes longer than meshing.
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

/// The surface is to the right of the boundary. Returns the first problem, or an empty text.
std::string CheckTriangles(
  const std::vector<PlanePoint>& plane, const Loops& boundary, const Triangles& triangles, Kind kind = Kind::Delaunay);

/// Adds Euler's formula per patch. Patches must be connected, with one outline and loops around holes.
std::string CheckMesh(const BoundedHorizon& horizon, const Triangles& triangles, Kind kind = Kind::Delaunay);

/// Throws std::logic_error for a problem in the mesh of `method`. Call it as `if (MeshChecker::IsOn)`.
void Require(const char* method, const std::vector<PlanePoint>& plane, const Loops& boundary,
  const Triangles& triangles, Kind kind = Kind::Delaunay);

/// Twice the signed area; positive for a left turn.
Int128 Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// Returns 1 inside, 0 on and -1 outside of the circle of a, b and c, which must turn left.
int SideOfCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d);
}

#endif
