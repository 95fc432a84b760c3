// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fewer points where a horizon is flat and far from its boundary (thesis 4.3.2, Alg. 4.2 and 4.3, eq. 4.1 to 4.5).
//
// The points of each patch are sorted into cubes, which are cut into octants as need be; every piece then becomes its
// barycentre, or the input point nearest to that. Cubes with boundary points, the first ring, are cut by how densely
// these lie. Each further ring, the cubes that touch the one before, is cut by curvature, and at least to the size that
// is nearest to the mean of the pieces of the ring before: so sizes change steadily from the boundary to the inside.
//
// Beyond the thesis:
//  - A cell is never halved to a side below one column. One that would have to be stays as it is. (A cell with one
//    boundary point never meets the criterion, so that the pseudo-code does not end.)
//  - Points that all lie in one place, on a line or on a plane have no curvature, whatever the threshold.
//  - Where a cell of the first ring is cut, pieces without boundary points have no ring before them: curvature alone
//    decides.
//  - At a cliff higher than a cell, cubes can touch none of the ring before. They follow once no others do, and what is
//    beside them in plan counts as touching then. Cubes that nothing leads to come last, cut by curvature alone.
//  - In plan, pieces can lie above each other; no two points are made in one place all the same (CellSimplifier.h).

#ifndef SeismicHorizonsElaborateSimplification_h
#define SeismicHorizonsElaborateSimplification_h

#include "CellSimplifier.h"
#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

namespace SeismicHorizons
{
struct ElaborateOptions : CellOptions
{
  ElaborateOptions(int cellSize = 8, double flatnessThreshold = 0.12)
    : CellOptions(cellSize)
    , FlatnessThreshold(flatnessThreshold)
  {
  }

  /// A cell is flat when the least eigenvalue of the covariance of its points is at most this part of the sum of the
  /// three (eq. 4.5). 0: on a plane, to 1/3: always.
  double FlatnessThreshold;
  /// A cell with boundary points stays whole when it has more of them than this per lattice unit of its side, and two
  /// of them are farther apart than the extent (eq. 4.1, 4.2), in lattice units. Both at least 0.
  double BoundaryDensityThreshold = 0.25;
  double BoundaryExtentThreshold = 2.0;
  /// When its side is larger than this, in lattice units, its other points become one; else they go. At least 0.
  double BoundaryCellSizeThreshold = 2.0;
  /// How many times as large as its neighbours in the ring before, in the mean, a cell may be, up to the nearest level.
  /// At least 1, which is eq. 4.3.
  double GrowthPerRing = 1.0;
};

/// Throws InputError on options out of range. Kept boundary points come first, in their order, then the points that
/// stand for cells: cell by cell in plan, row by row, from the bottom up. Linear in the points, the boundary and the
/// cells of the bounding box (times the number of halvings of a cell; and boundary points in a cell are compared in
/// pairs when the extent threshold is about as large as the cell). Cells of one ring run in parallel; results are the
/// same to the bit on every machine, for any number of threads.
Reduction SimplifyElaborate(
  const BoundedHorizon& horizon, const ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
