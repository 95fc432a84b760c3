// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Improves a mesh in groups of triangles (GroupMesh.h), one group per thread at a time.
//
// Edges between groups stay, so the next pass has other groups, and the result depends on the triangles alone.
//
//     first pass    | 1 | 2 | 3 |        second pass   |1|  2|  3|4|

#ifndef SeismicHorizonsMeshGroups_h
#define SeismicHorizonsMeshGroups_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Decimation.h"
#include "HeightMesh.h"

#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Changes the heights of a vertex in a column, by horizon.
using ColumnRule = std::function<void(const PlanePoint&, std::vector<double>&)>;

/// The mesh must keep the error, at columns and inner edges of all horizons, and still does so. Kept edges and fixed
/// vertices stay; others may move to other columns.
void ImproveInGroups(
  HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule, const Monitor& monitor);
}

#endif
