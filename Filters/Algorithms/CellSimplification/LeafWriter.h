// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes the output of a simplification out of the leaves of its cells.

#ifndef SeismicHorizonsLeafWriter_h
#define SeismicHorizonsLeafWriter_h

#include "CellLeaves.h"
#include "CellOptions.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <functional>

namespace SeismicHorizons
{
/// Keeps the boundary points and makes one point for each leaf that MergesInner. The inner
/// points of the other leaves go: each counts for the nearest boundary point of its leaf. Boundary points come first,
/// in the order of the input, then the points that stand for leaves, in the order of the leaves. Rings are left at 0.
Reduction WriteLeaves(const CellLeaves& leaves, RepresentativeKind representative, const Monitor& monitor);

/// The height at which the cell of a leaf begins, from its points and its level.
using CellBottom = std::function<double(const PointId* first, const PointId* last, int level)>;

/// Adds the cells of the leaves to what WriteLeaves made of them.
void ListCells(const CellLeaves& leaves, Reduction& result, const CellBottom& bottom);
}

#endif
