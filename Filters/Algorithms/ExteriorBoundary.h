// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The exterior boundary of each patch of a horizon (thesis 3.3, Def. 3.4, Alg. 3.1 and 3.2 with k = 1).
//
// At k = 1 both growth rules of the thesis are the classical following of outer borders (Suzuki and Abe, "Topological
// structural analysis of digitized binary images by border following", 1985): from each border point the eight
// neighbours are swept clockwise, beginning after the point one came from, and the first occupied one is next.
//
// Two things differ from the thesis's pseudo-code. It stops as soon as the walk is back at its first point, which cuts
// off the rest of a patch that only touches itself there; here the walk ends when it is about to repeat its first
// step. And a patch that lies inside the loop of another one has no loop of its own: it belongs to the outer patch,
// or two meshes would lie over each other.

#ifndef SeismicHorizonsExteriorBoundary_h
#define SeismicHorizonsExteriorBoundary_h

#include "Monitor.h"
#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
struct ExteriorBoundary
{
  /// One loop per patch, clockwise seen from +z, from the point of least x, then least y. Every hop leads to one of
  /// the eight neighbouring columns. A spur of one column's width is walked out and back; a single point is a loop of
  /// one.
  Loops Boundary;
  /// For each point the number of its patch, which is also the number of its loop. Patches are numbered in the order
  /// in which the rows of the lattice, from the least y, meet them.
  std::vector<std::int32_t> Patch;
};

/// `columns` holds the column of each point, no two the same (InputError). Linear in the points and in the columns of
/// their bounding box; beyond its result it needs 4 bytes per column of that box and one bit per point. Sequential:
/// a walk can not know where it ends.
ExteriorBoundary FindExteriorBoundary(const std::vector<PlanePoint>& columns, const Monitor& monitor = Monitor());
}

#endif
