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

/// The options that make loops run through all points of Topological4 and no others: a radius of 1, and all holes. For
/// Exterior they are returned as they are.
BoundaryOptions OptionsFor(BoundaryType type, const BoundaryOptions& options);

/// For each point what it is, given the boundary made with OptionsFor(type, ...). A point on an outline and on the loop
/// of a hole counts as exterior. A point with an empty column only at a corner is what the two points between them are.
std::vector<BoundaryKind> MarkBoundary(
  BoundaryType type, const std::vector<PlanePoint>& columns, const ExteriorBoundary& boundary);
}

#endif
