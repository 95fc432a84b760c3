// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of meshes, checked with none of the code that makes them.

#ifndef SeismicHorizonsMeshChecker_h
#define SeismicHorizonsMeshChecker_h

#include "Common/BoundedHorizon.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <string>

namespace MeshChecker
{
enum class Kind
{
  Delaunay,
  Any
};

/// Triangles turn counter-clockwise; every edge has at most one triangle on each side; the edges with one triangle are
/// the boundary edges; areas sum to that of the boundary (with the former: no overlap, nothing outside, no gap); all
/// points are used; every other edge is locally Delaunay, unless any mesh will do; Euler's formula holds patch by
/// patch. Empty when all is well, else what is wrong first.
std::string CheckMesh(const SeismicHorizons::BoundedHorizon& horizon,
  const SeismicHorizons::RawVector<SeismicHorizons::PointId>& triangles, Kind kind = Kind::Delaunay);
}

#endif
