// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true of the boundaries of cracked lattices, checked with none of the code that makes them.

#ifndef SeismicHorizonsCutChecker_h
#define SeismicHorizonsCutChecker_h

#include "CrackedPatches.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <string>
#include <vector>

namespace CutChecker
{
using CrackedPatches::CrackedPatch;

/// Loops hop between neighbours, or within the radius; never cross; one outline a patch; each point is inside its patch
/// and in no other; no cut is inside a patch or on a loop; and a hole has the size it should, or holds a cut. With
/// loops for all holes and a radius of 1, the area of the patches is that of the blocks the definition leaves, and
/// points are in one patch when its hops connect them. Empty when all is well.
std::string CheckBoundary(const CrackedPatch& patch, const SeismicHorizons::ExteriorBoundary& boundary,
  const SeismicHorizons::BoundaryOptions& options);

/// Whether no cut is inside some loops or on them, whose points stand on columns times a scale that 4 divides.
std::string CheckCuts(const CrackedPatch& patch, const std::vector<SeismicHorizons::PlanePoint>& places,
  const SeismicHorizons::Loops& loops, int scale);
}

#endif
