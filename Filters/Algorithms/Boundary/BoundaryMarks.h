// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points are on a boundary: on a loop, or, by the topological definition (thesis Def. 3.2), beside an empty
// column.

#ifndef SeismicHorizonsBoundaryMarks_h
#define SeismicHorizonsBoundaryMarks_h

#include "Common/DataModel.h"
#include "ExteriorBoundary.h"

#include <vector>

namespace SeismicHorizons
{
enum class BoundaryType
{
  Exterior = 0, // the points of the loops
  Topological4 = 1, // points with an empty column side by side
  Topological8 = 2 // points with an empty column side by side or corner to corner
};

/// The options under which the loops run through all points of a topological boundary with four neighbours, and no
/// others: neighbouring columns, all holes. Exterior leaves them as they are.
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options);

/// For each point what it is, given the loops made with OptionsFor(type, ...). A point on loops of both kinds is on the
/// exterior one. A point that only has an empty column corner to corner is what the points beside it are.
std::vector<BoundaryKind> MarkBoundary(
  BoundaryType type, const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary);
}

#endif
