// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits heights of vertices to columns, and to grid lines that inner edges cross.
//
// Squares of errors are minimized; for a small mean error, powers 1.5 and 1 follow, because squares prefer many small
// errors to integer heights that a mesh could meet. For a small largest error, the power is 4, twice. A step of power p
// weighs points by errors to the power p - 2 (iteratively reweighted least squares; Lawson 1961), and is divided by p -
// 1 if p > 2.

#ifndef SeismicHorizonsHeightFit_h
#define SeismicHorizonsHeightFit_h

#include "Common/Base/Monitor.h"
#include "HeightMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Edges weigh less where the mean error is minimized, which counts columns alone: at a cliff any edge is far from the
/// lines between columns.
constexpr double EdgeWeight = 0.1;

enum class FitAim
{
  LargestError,
  Squares,
  Mean
};

/// A rule may change fitted heights, which have the same vertices in each horizon.
using HeightRule = std::function<void(std::vector<InnerHeights>&)>;

/// Vertices on loops stay; heights stay within `reach` of their columns. The mesh is unchanged afterwards.
std::vector<InnerHeights> FitAllHeights(
  HeightMesh& mesh, FitAim aim, double reach, const HeightRule& rule, const Monitor& monitor);

/// Moves vertices all the way, a half, a quarter, or not at all, in all horizons alike, so that no triangle and no
/// inner edge with a moved corner exceeds the error.
void MoveHeightsWithin(HeightMesh& mesh, double error, const std::vector<InnerHeights>& heights);
}

#endif
