// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fewer points where a horizon is flat and far from its boundary (thesis 4.3.2, Alg. 4.2 and 4.3, eq. 4.1 to 4.5).
//
// The points of each patch are sorted into cubes. Cubes are cut into octants, and these again where need be; both are
// called cells. For the points in each cell that is not cut any further, a leaf, their barycentre stands, or the input
// point nearest to that. Cubes with boundary points, the first ring, are cut by how densely these lie. Each further
// ring is the cubes that touch the one before. It is cut by curvature, and at least to the size that is nearest to the
// mean of its neighbours in the ring before, so that sizes change gradually from the boundary to the inside.
//
// How eq. 4.3 is read: size(C) = 1/m sum of size(C_j) over the m neighbouring *cells* of the ring before. Rings are
// made of cubes, so that C_j is a cube, and counts once, however often it was cut. The size of one that was cut into
// leaves of different sizes is their mean. The text speaks of an average *level*, the equation of sizes: we go by the
// equation. (The mean of levels is the geometric mean of sizes, which is smaller: with it cells shrink more from ring
// to ring.)
//
// Beyond the thesis:
//  - A cell is not halved to a side below the smallest cell size, at least one column; one that would have to be stays
//    as it is. (4.3.2.4.1 has a threshold of size for inner cells alone; but a cell with one boundary point never meets
//    the criterion, so that the pseudo-code does not end.)
//  - Points that all lie in one place, on a line or on a plane have no curvature, whatever the threshold.
//  - Where a cube of the first ring is cut, octants without boundary points have no ring before them: curvature alone
//    decides.
//  - At a cliff higher than a cube, the cubes beyond it touch none of the ring before. Once no other cubes are left,
//    they are taken as the next ring, and those beside them in plan count as touching them. Cubes that nothing leads to
//    come last, and are cut by curvature alone.
//  - Where a cell is cut, the points on each side of the cuts are in cubes of their own (CellLeaves.cxx).
//  - Leaves can lie above each other. No two points are made in one place in plan all the same (LeafWriter.cxx).

#ifndef SeismicHorizonsElaborateSimplification_h
#define SeismicHorizonsElaborateSimplification_h

#include "CellOptions.h"
#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

namespace SeismicHorizons
{
/// What counts once in the mean size of the neighbours: each cube (eq. 4.3), or each of the leaves it was cut into.
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

  /// A cell is flat when the least eigenvalue of the covariance of its points is at most this part of the sum of the
  /// three (eq. 4.5). From 0, only a plane is flat, to 1/3, everything is.
  double FlatnessThreshold;
  /// A cell with boundary points is not cut when it has more of them than this per lattice unit of its side, and two of
  /// them are farther apart than the extent (eq. 4.1, 4.2), in lattice units. Both at least 0.
  double BoundaryDensityThreshold = 0.25;
  double BoundaryExtentThreshold = 2.0;
  /// When the side of a leaf with boundary points is larger than this, in lattice units, one point represents its other
  /// points; else they go. At least 0.
  double BoundaryCellSizeThreshold = 2.0;
  /// No cell is halved to a side below this, in lattice units. At least 1; where it is more than half of the cell size
  /// no cell is halved at all.
  double SmallestCellSize = 1.0;
  NeighbourMeanKind NeighbourMean = NeighbourMeanKind::OverCubes;
  /// How many times as large as its neighbours in the ring before, in the mean, a cell may be, rounded to the nearest
  /// level. At least 1, which is eq. 4.3.
  double GrowthPerRing = 1.0;
};

/// Throws InputError on options out of range. Boundary points come first, in their order, then the points that stand
/// for leaves: row by row in plan, in each cell of the grid by patch, and from the bottom up. Linear in the points and
/// the boundary, times the number of halvings of a cell, and in the cells of the bounding box where many have points;
/// where the extent threshold is about as large as the cell, boundary points in it are compared in pairs. Cubes of one
/// ring run in parallel; results are the same to the bit on every machine, for any number of threads.
Reduction SimplifyElaborate(
  const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
