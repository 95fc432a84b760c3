// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One point per square cell inside the boundary (thesis 4.3.1, Alg. 4.1): vertex clustering on a regular grid in plan
// that leaves the boundary alone.
//
// Cells start at the least corner of the bounding box of the horizon. In a cell each patch is on its own: if it has
// boundary points there, these stay and its other points go; else the barycentre of its points stands for them, or the
// input point nearest to that. Where a boundary edge crosses the cell (a long one can, without an end in it), the
// barycentre can lie on the wrong side; then the nearest point stands for the cell in any case.

#ifndef SeismicHorizonsRoughSimplification_h
#define SeismicHorizonsRoughSimplification_h

#include "CellSimplifier.h"
#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

namespace SeismicHorizons
{
/// `options` can be just the cell size: in columns, at least 1 (InputError). Kept boundary points come first, in their
/// order, then the points that stand for cells, row by row. Linear in the points, the boundary and the cells of the
/// bounding box. Cells run in parallel. A sum is taken over the points of a cell in their order, so that results are
/// the same to the bit on every machine, for any number of threads.
Reduction SimplifyRough(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor = Monitor());
}

#endif
