// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsEdgeLoops_h
#define SeismicHorizonsEdgeLoops_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Joins edges to closed loops, at points with several in any order. As many edges must end at a point as start there.
Loops JoinEdges(std::vector<Edge> edges);
}

#endif
