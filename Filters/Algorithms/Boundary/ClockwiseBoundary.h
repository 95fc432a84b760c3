// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boundary by clockwise growth, for k > 1 or with cuts: the outer faces of the graph of admissible hops (PlanarHops.h),
// and on request its inner faces that are holes.

#ifndef SeismicHorizonsClockwiseBoundary_h
#define SeismicHorizonsClockwiseBoundary_h

#include "CutFaces.h"
#include "ExteriorBoundary.h"

#include <vector>

namespace SeismicHorizons
{
struct SeamPresence;

/// Unlike FindExteriorBoundary, it checks no options and ignores MinimumPatchSize. `cracks` receives input for
/// FindCracks.
ExteriorBoundary FindClockwiseBoundary(const ColumnIndex& index, const BoundaryOptions& options,
  const SeamPresence& seams, std::vector<CrackSide>& cracks, const Monitor& monitor);
}

#endif
