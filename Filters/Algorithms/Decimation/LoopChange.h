// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Moves the boundary of a mesh. Triangles that no new edge of a loop enters stay; the rest of the new inside, between
// these triangles and the new loops, is triangulated without inner vertices.

#ifndef SeismicHorizonsLoopChange_h
#define SeismicHorizonsLoopChange_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "PlaneMesh.h"

#include <optional>
#include <vector>

namespace SeismicHorizons
{
struct LoopChange
{
  std::vector<TriangleId> Gone;
  RawVector<PointId> Added; // corners of triangles, which are points
};

/// `sources` has the point of each vertex, and `mayStay` 0 for vertices that may not remain. Returns nothing if the new
/// inside cannot be covered once.
std::optional<LoopChange> ChangeLoops(const PlaneMesh& mesh, const std::vector<PointId>& sources,
  const std::vector<unsigned char>& mayStay, PlanePoints places, const Loops& boundary);
}

#endif
