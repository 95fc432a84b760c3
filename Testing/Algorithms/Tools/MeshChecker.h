// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of boundaries and meshes, checked with none of the code that makes them. Each check gives an empty
// text when all is well, else what is wrong first.

#ifndef SeismicHorizonsMeshChecker_h
#define SeismicHorizonsMeshChecker_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/BoundedHorizon.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <string>
#include <vector>

namespace MeshChecker
{
/// Loops hop between neighbouring columns, do not cross themselves, run clockwise from their least point, and visit
/// just those points of a patch that have empty outside beside them; patches are what hangs together once enclosed
/// holes are filled.
std::string CheckExteriorBoundary(
  const std::vector<SeismicHorizons::PlanePoint>& columns, const SeismicHorizons::ExteriorBoundary& boundary);

/// The contract for any radius, rule and choice of holes, by looking at every pair: loops hop between points within the
/// radius and over none, never cross themselves or each other, begin at their least point, and turn the right way;
/// what hangs together is in one patch; each point is inside or on the loop of its patch, not inside a hole of it, and
/// in no other patch; holes have the size they should.
std::string CheckBoundary(const std::vector<SeismicHorizons::PlanePoint>& columns,
  const SeismicHorizons::ExteriorBoundary& boundary, const SeismicHorizons::BoundaryOptions& options);

/// Whether a place is inside a set of loops, on them, or outside: 1, 0 or -1.
int Locate(const std::vector<SeismicHorizons::PlanePoint>& places, const SeismicHorizons::Loops& boundary,
  const SeismicHorizons::PlanePoint& place);

/// 1 when d is inside the circle of a, b and c, which turn counter-clockwise, 0 when on it, -1 when outside.
int SideOfCircle(const SeismicHorizons::PlanePoint& a, const SeismicHorizons::PlanePoint& b,
  const SeismicHorizons::PlanePoint& c, const SeismicHorizons::PlanePoint& d);

/// No two boundary hops cross, and no point lies on one between its ends.
std::string CheckCrossings(const SeismicHorizons::BoundedHorizon& horizon);

/// Triangles turn counter-clockwise; every edge has at most one triangle on each side; the edges with one triangle are
/// the boundary hops; areas sum to that of the boundary (with the former: no overlap, nothing outside, no gap); all
/// points are used; every other edge is locally Delaunay; Euler's formula holds patch by patch.
std::string CheckMesh(const SeismicHorizons::BoundedHorizon& horizon,
  const SeismicHorizons::RawVector<SeismicHorizons::PointId>& triangles);
}

#endif
