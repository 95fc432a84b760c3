// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Creates the output of a simplification from the leaves of its cells.

#ifndef SeismicHorizonsLeafWriter_h
#define SeismicHorizonsLeafWriter_h

#include "CellLeaves.h"
#include "CellOptions.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"

#include <functional>

namespace SeismicHorizons
{
/// Boundary points come first, in the order of the input, then a point for each leaf that MergesInner. Inner points of
/// other leaves are counted with the nearest boundary point of their leaf. Rings remain 0.
Reduction WriteLeaves(const CellLeaves& leaves, RepresentativeKind representative, const Monitor& monitor);

using CellBottom = std::function<double(const PointId* first, const PointId* last, int level)>;

void ListCells(const CellLeaves& leaves, Reduction& result, const CellBottom& bottom);
}

#endif
