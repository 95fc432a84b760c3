// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boundary by clockwise growth for k > 1: the outer faces of the graph of admissible hops (PlanarHops.h), and on
// request those of its inner faces that are holes.

#ifndef SeismicHorizonsClockwiseBoundary_h
#define SeismicHorizonsClockwiseBoundary_h

#include "ExteriorBoundary.h"

namespace SeismicHorizons
{
struct SeamPresence;

/// As FindExteriorBoundary, but for MinimumPatchSize and for checks of the options.
ExteriorBoundary FindClockwiseBoundary(const std::vector<PlanePoint>& columns, const BoundaryOptions& options,
  const SeamPresence& seams, const Monitor& monitor);
}

#endif
