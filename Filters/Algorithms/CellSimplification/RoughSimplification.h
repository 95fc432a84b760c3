// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One point per square cell inside the boundary (thesis 4.3.1, Alg. 4.1): vertex clustering on a regular grid in plan
// that preserves the boundary.
//
// Cells start at the least corner of the bounding box. Points of one patch (and side of the cuts, CellLeaves.cxx) in a
// cell are a group. A group with boundary points keeps these alone; the barycentre, or the input point nearest to it,
// represents any other group. A barycentre on the wrong side of a long boundary edge through the cell is replaced by
// the nearest point.

#ifndef SeismicHorizonsRoughSimplification_h
#define SeismicHorizonsRoughSimplification_h

#include "CellOptions.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"

namespace SeismicHorizons
{
/// The cell size is in columns, at least 1 (InputError). Boundary points come first, then representatives row by row.
/// Memory is linear in the points, however far apart.
Reduction SimplifyRough(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor = Monitor());
}

#endif
