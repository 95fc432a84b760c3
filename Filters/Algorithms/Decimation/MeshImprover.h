// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts within an error, and improves such a mesh.

#ifndef SeismicHorizonsMeshImprover_h
#define SeismicHorizonsMeshImprover_h

#include "Common/Base/Monitor.h"
#include "Decimation.h"
#include "HeightFit.h"
#include "HeightMesh.h"
#include "MeshGroups.h"

#include <vector>

namespace SeismicHorizons
{
/// The rule applies to fitted heights.
void InsertToError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule = HeightRule());

/// Continues in a mesh within the error where these triangles have changed. Returns all that have changed since.
std::vector<TriangleId> InsertWhereChanged(
  HeightMesh& mesh, const DecimationOptions& options, std::vector<TriangleId> changed, const Monitor& monitor);

/// The mesh must keep the error, at columns and inner edges of all horizons, and still does so. Kept edges and fixed
/// vertices stay; others may move to other columns, where the rule applies to their heights.
void ImproveWithinError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const ColumnRule& rule = ColumnRule());
}

#endif
