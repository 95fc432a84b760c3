// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flips sides of a mesh for which it comes nearer to the horizon: data-dependent triangulation (Dyn, Levin and Rippa
// 1990, "Data dependent triangulations for piecewise linear interpolation").

#ifndef SeismicHorizonsEdgeFlips_h
#define SeismicHorizonsEdgeFlips_h

#include "Common/Monitor.h"
#include "HeightMesh.h"
#include "MeshCost.h"

namespace SeismicHorizons
{
/// Flips all sides that gain, the largest gains first, until none does. The errors of triangles are kept in the mesh.
void FlipEdges(HeightMesh& mesh, const MeshCost& cost, const Monitor& monitor);
}

#endif
