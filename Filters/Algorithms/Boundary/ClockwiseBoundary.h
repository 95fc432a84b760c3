// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boundary by clockwise growth for k > 1: the outer faces of the graph of admissible hops (PlanarHops.h), and on
// request those of its inner faces that are holes.

#ifndef SeismicHorizonsClockwiseBoundary_h
#define SeismicHorizonsClockwiseBoundary_h

#include "CutFaces.h"
#include "ExteriorBoundary.h"

#include <vector>

namespace SeismicHorizons
{
struct SeamPresence;

/// As FindExteriorBoundary, but for MinimumPatchSize and for checks of the options. Its cracks are given by the sides
/// of their faces, for FindCracks.
ExteriorBoundary FindClockwiseBoundary(const ColumnIndex& index, const BoundaryOptions& options,
  const SeamPresence& seams, std::vector<CrackSide>& cracks, const Monitor& monitor);
}

#endif
