// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is done to a mesh for an error, and then for fewer vertices: points are inserted, heights fitted, sides flipped,
// vertices removed.

#ifndef SeismicHorizonsMeshImprover_h
#define SeismicHorizonsMeshImprover_h

#include "Common/Monitor.h"
#include "Decimation.h"
#include "HeightFit.h"
#include "HeightMesh.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Inserts points until the error of the options is kept, for all horizons: the effort Fast. Fitted heights keep to a
/// rule.
void InsertToError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule = HeightRule());

/// Of a mesh that keeps the error of the options, at columns and at inner sides, for all its horizons, and still does
/// so after it. Fitted heights keep to a rule; the sides and vertices that have to stay do.
void ImproveWithinError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule = HeightRule());

/// Until so many vertices are left, or none can go. All triangles were measured after the last change.
void ReduceToNumber(HeightMesh& mesh, std::size_t vertices, const DecimationOptions& options, const Monitor& monitor);

/// Flips sides for which the mesh is nearer to the horizon. All triangles were measured after the last change.
void FlipToNumber(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor);

/// Fits heights, so that the largest error becomes no larger, or,
/// with the other priority, when neither the mean error nor that of squares does: heights that are whole numbers can
/// fit best as they are, as many points then lie right on the mesh.
void FitToNumber(HeightMesh& mesh, DecimationPriority priority, const Monitor& monitor);
}

#endif
