// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of the vertices of a mesh for which it is nearer to the horizon than with those of their columns.
//
// Errors are those at columns, each of which counts once, and where inner sides of the mesh cross lines between
// columns.
//
// For a small mean error the sum of the squares of all errors is made least, and then that of their p-th powers small,
// p being 1.5 and then 1: squares alone are made less by many small errors, where heights are whole numbers that a
// mesh could have. For a small largest error p is 3 and then 4. Each step is one of least squares, in which a point
// weighs as much as the (p - 2)-th power of its error so far (iteratively reweighted least squares; Lawson 1961), and
// goes a (p - 1)-th part of the way where p is above 2.

#ifndef SeismicHorizonsHeightFit_h
#define SeismicHorizonsHeightFit_h

#include "Common/Monitor.h"
#include "Decimation.h"
#include "HeightMesh.h"

namespace SeismicHorizons
{
/// The heights of the vertices of the mesh that are on no loop: none is farther than `reach` from that of its column.
InnerHeights FitHeights(const HeightMesh& mesh, DecimationPriority priority, double reach, const Monitor& monitor);

/// Gives the mesh new heights, for which no triangle and no inner side has an error above the one given, but where all
/// its corners have the heights they had: a vertex moves all the way, a half, a quarter, or stays.
void MoveHeightsWithin(HeightMesh& mesh, double error, const InnerHeights& heights);
}

#endif
