// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One point per square cell inside the boundary (thesis 4.3.1, Alg. 4.1): vertex clustering on a regular grid in plan
// that leaves the boundary as it is.
//
// Cells start at the least corner of the bounding box of the horizon. The points of one patch in one cell are a group,
// and where the cell is cut, those on one side (CellLeaves.cxx).
// A group with boundary points keeps these, and its other points go. For any other group its barycentre stands, or the
// input point nearest to that. A long boundary edge can cross a cell without having an end in it: a barycentre on the
// wrong side of it is not used, but the nearest point.

#ifndef SeismicHorizonsRoughSimplification_h
#define SeismicHorizonsRoughSimplification_h

#include "CellOptions.h"
#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

namespace SeismicHorizons
{
/// `options` can be just the cell size: in columns, at least 1 (InputError). Kept boundary points come first, in their
/// order, then the points that stand for cells, row by row. Memory is linear in the points and the boundary, however
/// far parts are from each other; so is time, but for sorting where most cells are empty. Cells run in parallel. A sum
/// is taken over the points of a cell in their order, so that results are the same to the bit on every machine, for any
/// number of threads.
Reduction SimplifyRough(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor = Monitor());
}

#endif
