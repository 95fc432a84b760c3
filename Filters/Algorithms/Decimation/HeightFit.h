// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits heights of vertices to columns, and to grid lines that inner edges cross.
//
// The sum of fourth powers of errors is minimized, for a small largest error, in two steps. A step weighs points by
// squares of their errors (iteratively reweighted least squares; Lawson 1961), and goes a third of the way.

#ifndef SeismicHorizonsHeightFit_h
#define SeismicHorizonsHeightFit_h

#include "Common/Base/Monitor.h"
#include "HeightMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// A rule may change fitted heights, which have the same vertices in each horizon.
using HeightRule = std::function<void(std::vector<InnerHeights>&)>;

/// Vertices on loops stay; heights stay within `reach` of their columns. The mesh is unchanged afterwards. Edges count
/// where they cross grid lines if `withEdges` is true.
std::vector<InnerHeights> FitAllHeights(
  HeightMesh& mesh, double reach, bool withEdges, const HeightRule& rule, const Monitor& monitor);

/// Moves vertices all the way, a half, a quarter, or not at all, in all horizons alike, so that no triangle and no
/// inner edge with a moved corner exceeds the error.
void MoveHeightsWithin(HeightMesh& mesh, double error, const std::vector<InnerHeights>& heights);
}

#endif
