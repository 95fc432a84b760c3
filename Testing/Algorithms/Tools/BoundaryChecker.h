// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of boundaries, checked with none of the code that makes them. Each check gives an empty text when
// all is well, else what is wrong first.

#ifndef SeismicHorizonsBoundaryChecker_h
#define SeismicHorizonsBoundaryChecker_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <string>
#include <vector>

namespace BoundaryChecker
{
/// The contract for any radius, rule and choice of holes, by looking at every pair: loops hop between points within the
/// radius and over none, never cross themselves or each other, begin at their least point, and turn the right way;
/// points within the radius are in one patch; each point is inside or on the outline of its patch, not inside a hole of
/// it, and in no other patch; holes have the size they should. With cuts, what these decide is left out: which points
/// are in one patch, and which holes have loops (CrackedPatches.h).
std::string CheckBoundary(const std::vector<SeismicHorizons::PlanePoint>& columns,
  const SeismicHorizons::ExteriorBoundary& boundary, const SeismicHorizons::BoundaryOptions& options);

/// No two boundary edges cross, and no point lies on one between its ends.
std::string CheckCrossings(const SeismicHorizons::BoundedHorizon& horizon);
}

#endif
