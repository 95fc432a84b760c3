// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of triangles that close cracks, checked with none of the code that makes them.

#ifndef SeismicHorizonsClosingChecker_h
#define SeismicHorizonsClosingChecker_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "CrackedPatches.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ClosingChecker
{
using CrackedPatches::CrackedPatch;
using SeismicHorizons::BoundedHorizon;
using SeismicHorizons::PlanePoint;
using SeismicHorizons::PointId;
using SeismicHorizons::RawVector;

/// The edges of loops that have a crack to their left, by their numbers through all loops, and the points of open ends.
struct Outline
{
  std::vector<bool> IsCutoff;
  std::set<std::pair<PlanePoint, PlanePoint>> OpenEnds;
};

/// That of the closing triangles of a horizon.
Outline FindOutline(const BoundedHorizon& horizon, const RawVector<PointId>& closing);

/// That of a lattice with all its points and a radius of 1, block by block.
Outline FindOutlineOfBlocks(const CrackedPatch& patch, const BoundedHorizon& horizon);

/// The outline of a horizon whose loops are those of another one without some points.
Outline SimplifyOutline(const BoundedHorizon& full, const Outline& outline, const BoundedHorizon& simplified);

/// Closing triangles turn counter-clockwise and overlap none of the mesh or of their own; every edge has one triangle
/// on each side at most; and what has a triangle on one side alone is a cutoff, which is closed from its left, or an
/// open end.
/// Empty when all is well, else what is wrong first.
std::string CheckClosing(const BoundedHorizon& horizon, const RawVector<PointId>& mesh,
  const RawVector<PointId>& closing, const Outline& outline);

/// With a radius of 1 and all points, closing triangles have the area of the blocks that cuts opened, and pass no
/// missing column.
std::string CheckBlocks(const CrackedPatch& patch, const BoundedHorizon& horizon, const RawVector<PointId>& closing);
}

#endif
