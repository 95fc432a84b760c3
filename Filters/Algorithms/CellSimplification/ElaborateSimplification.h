// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reduces points where a horizon is flat and far from its boundary (thesis 4.3.2, Alg. 4.2 and 4.3, eq. 4.1 to 4.5).
//
// Points of each patch are sorted into cubes, which are cut into octants; both are called cells. The barycentre, or the
// input point nearest to it, represents the points of each leaf. Cubes with boundary points, the first ring, are cut by
// the density of these points. Each further ring, the cubes that touch the previous one, is cut by curvature, and at
// least to the mean size of its neighbours in the previous ring, so that sizes change gradually.
//
// Interpretation of eq. 4.3, size(C) = 1/m sum of size(C_j) over m neighbouring cells of the previous ring: C_j is a
// cube, which counts once; its size is the mean of its leaves. The text averages levels, the equation sizes; the
// equation is used. (The mean of levels is a geometric mean of sizes, which shrinks cells faster.)
//
// Differences from the thesis:
//  - No cell is halved below the smallest cell size, at least one column. (4.3.2.4.1 limits inner cells alone, but a
//    cell with one boundary point never meets the criterion, so that the pseudo-code does not end.)
//  - Points in one place, on a line or on a plane have no curvature, whatever the threshold.
//  - Octants without boundary points in the first ring have no previous ring, and are cut by curvature alone.
//  - Cubes beyond a cliff higher than a cube touch no ring. Once no other cubes remain, those next to a ring in plan
//    follow, then isolated cubes, which are cut by curvature alone.
//  - Points on different sides of cuts are in different cubes (CellLeaves.cxx).
//  - Leaves can lie above each other, but no two new points share a place in plan (LeafWriter.cxx).
//
// Time is linear in the points times the number of halvings, but boundary points are compared in pairs if the extent
// threshold is about the cell size.

#ifndef SeismicHorizonsElaborateSimplification_h
#define SeismicHorizonsElaborateSimplification_h

#include "CellOptions.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"

namespace SeismicHorizons
{
/// The mean size of neighbours counts each cube once (eq. 4.3), or each leaf.
enum class NeighbourMeanKind
{
  OverCubes = 0,
  OverPieces = 1
};

struct ElaborateOptions : CellOptions
{
  ElaborateOptions(int cellSize = 8, double flatnessThreshold = 0.12)
    : CellOptions(cellSize)
    , FlatnessThreshold(flatnessThreshold)
  {
  }

  /// The least eigenvalue of the covariance, as a fraction of the sum of all three (eq. 4.5), is compared with this: 0
  /// for a plane, 1/3 for any points.
  double FlatnessThreshold;
  /// A cell stays whole if it has more boundary points per lattice unit of its size, and two of them are farther apart
  /// than the extent (eq. 4.1, 4.2), in lattice units.
  double BoundaryDensityThreshold = 0.25;
  double BoundaryExtentThreshold = 2.0;
  /// One point represents the inner points of leaves with boundary points above this size, in lattice units; they are
  /// dropped in smaller leaves.
  double BoundaryCellSizeThreshold = 2.0;
  /// This is in lattice units, at least 1. Above half of the cell size, no cell is halved.
  double SmallestCellSize = 1.0;
  NeighbourMeanKind NeighbourMean = NeighbourMeanKind::OverCubes;
  /// A cell may exceed the mean size of its neighbours in the previous ring by this factor, rounded to a level; 1 is
  /// eq. 4.3.
  double GrowthPerRing = 1.0;
};

/// Throws InputError for options out of range. Boundary points come first, then representatives of leaves by cell,
/// patch and height.
Reduction SimplifyElaborate(
  const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
