// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts, fits, flips and removes, for an error or for a number of vertices.

#ifndef SeismicHorizonsMeshImprover_h
#define SeismicHorizonsMeshImprover_h

#include "Common/Base/Monitor.h"
#include "Decimation.h"
#include "HeightFit.h"
#include "HeightMesh.h"
#include "MeshGroups.h"

#include <cstddef>

namespace SeismicHorizons
{
/// The rule applies to fitted heights.
void InsertToError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule = HeightRule());

/// The mesh must keep the error, at columns and inner edges of all horizons, and still does so. Kept edges and fixed
/// vertices stay; others may move to other columns, where the rule applies to their heights.
void ImproveWithinError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const ColumnRule& rule = ColumnRule());

/// Stops early if no vertex can be removed. Errors of all triangles must be current.
void ReduceToNumber(HeightMesh& mesh, std::size_t vertices, const DecimationOptions& options, const Monitor& monitor);

/// Errors of all triangles must be current.
void FlipToNumber(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor);

/// Undoes the fit if the largest error or, with the other priority, the mean or squared error grows: integer heights
/// can fit best as they are, with many points exactly on the mesh.
void FitToNumber(HeightMesh& mesh, DecimationPriority priority, const Monitor& monitor);
}

#endif
