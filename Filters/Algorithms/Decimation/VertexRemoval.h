// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes vertices inside a mesh by collapsing a side each, the cheapest first: half-edge collapses (Hoppe 1996,
// "Progressive meshes").
//
// This is done in rounds. In each, all vertices around which triangles have changed are tried at once. Then the cheaper
// ones are removed, the cheapest first, but for those beside one that the round has removed.

#ifndef SeismicHorizonsVertexRemoval_h
#define SeismicHorizonsVertexRemoval_h

#include "Common/Monitor.h"
#include "HeightMesh.h"
#include "MeshCost.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Until none can go for the cost's error and angle, or so many vertices are left, those of loops included, which stay.
void RemoveVertices(HeightMesh& mesh, const MeshCost& cost, std::size_t leastVertices, const Monitor& monitor);
}

#endif
