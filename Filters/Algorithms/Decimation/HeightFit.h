// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of the vertices of a mesh for which it is nearer to the horizon than with those of their columns.
//
// Errors are those at columns, each of which counts once, and where inner sides of the mesh cross lines between
// columns.
//
// The sum of the squares of all errors is made least; or, for a small mean error, then also that of their p-th powers
// small, p being 1.5 and then 1: squares alone are made less by many small errors, where heights are whole numbers that
// a mesh could have. For a small largest error p is 4, twice. Each step is one of least squares, in which a point
// weighs as much as the (p - 2)-th power of its error so far (iteratively reweighted least squares; Lawson 1961), and
// goes a (p - 1)-th part of the way where p is above 2.

#ifndef SeismicHorizonsHeightFit_h
#define SeismicHorizonsHeightFit_h

#include "Common/Monitor.h"
#include "HeightMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Which error of a mesh becomes small.
enum class FitAim
{
  LargestError,
  Squares, // their sum
  Mean
};

/// The heights of the vertices of the mesh that are on no loop: none is farther than `reach` from that of its column.
InnerHeights FitHeights(const HeightMesh& mesh, FitAim aim, double reach, const Monitor& monitor);

/// May change heights that were fitted, those of each horizon at the same vertices.
using HeightRule = std::function<void(std::vector<InnerHeights>&)>;

/// The same of each horizon, with a rule for all of them. The mesh is what it was afterwards.
std::vector<InnerHeights> FitAllHeights(
  HeightMesh& mesh, FitAim aim, double reach, const HeightRule& rule, const Monitor& monitor);

/// Gives the mesh new heights, for which no triangle and no inner side has an error above the one given, but where all
/// its corners have the heights they had: a vertex moves all the way, a half, a quarter, or stays, in all horizons
/// alike.
void MoveHeightsWithin(HeightMesh& mesh, double error, const std::vector<InnerHeights>& heights);
}

#endif
