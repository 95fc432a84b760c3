// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops out of edges in any order, with the patches that they and the triangles of a mesh connect.

#ifndef SeismicHorizonsLoopAssembly_h
#define SeismicHorizonsLoopAssembly_h

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct AssembledLoops
{
  /// First an outline for each patch, then loops of holes, in the order in which rows from the least y meet them. Each
  /// begins at its point of least x, then least y.
  Loops Boundary;
  std::vector<std::int32_t> Patch; // by vertex
  std::size_t NumberOfPatches = 0;
};

/// `edges` are those of loops, with the surface of the triangles to their right; no two cross or are the same. A vertex
/// without edges and triangles is a patch, and a loop, of its own. Throws InputError when the edges are no such loops.
AssembledLoops AssembleLoops(
  const std::vector<PlanePoint>& vertices, const std::vector<Edge>& edges, const RawVector<PointId>& triangles);
}

#endif
