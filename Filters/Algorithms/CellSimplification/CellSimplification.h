// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simplifications of the inside (thesis 4.3): rough, elaborate, and both to a number of points.

#ifndef SeismicHorizonsCellSimplification_h
#define SeismicHorizonsCellSimplification_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"

#include <cstddef>

namespace SeismicHorizons
{
/// The mean, or the input point nearest to it, represents the points of a cell.
enum class RepresentativeKind
{
  Barycentre = 0,
  NearestPoint = 1
};

struct CellOptions
{
  CellOptions(int cellSize, RepresentativeKind representative = RepresentativeKind::Barycentre, bool listCells = false)
    : CellSize(cellSize)
    , Representative(representative)
    , ListCells(listCells)
  {
  }

  int CellSize; // This is in columns, at least 1.
  RepresentativeKind Representative;
  bool ListCells;
};

/// The cell size is in columns, at least 1 (InputError). Boundary points come first, then representatives row by row.
/// Memory is linear in the points, however far apart.
Reduction SimplifyRough(const BoundedHorizon& horizon, const CellOptions& options, const Monitor& monitor = Monitor());

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

/// Throws InputError if boundary points and one point per patch exceed `most`. Takes about 2 log2(cell size) runs.
Reduction SimplifyRoughTo(
  std::size_t most, const BoundedHorizon& horizon, CellOptions& options, const Monitor& monitor = Monitor());

/// The cell size changes if no threshold suffices. Takes at most about 12 + 3 log2(cell size) runs.
Reduction SimplifyElaborateTo(
  std::size_t most, const BoundedHorizon& horizon, ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
