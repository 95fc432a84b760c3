// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The thresholds of a simplification of the inside that leave a number of points (thesis 6.2).
//
//   rough       the smallest cell size that leaves no more than the number
//   elaborate   a flatness threshold that does, found by halving, to 3 % of the number; where even the largest one
//               leaves more, with larger cells, and where even 0 leaves fewer, with smaller ones
//
// Boundary points are kept, so that there are at least as many.

#ifndef SeismicHorizonsPointTarget_h
#define SeismicHorizonsPointTarget_h

#include "CellOptions.h"
#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Types.h"
#include "ElaborateSimplification.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Leaves at most `most` points, and sets the cell size. Throws InputError where the boundary points and one point for
/// each patch are more, and as SimplifyRough does. About as many runs of that as the cell size has binary digits,
/// twice.
Reduction SimplifyRoughTo(
  std::size_t most, const BoundedHorizon& horizon, CellOptions& options, const Monitor& monitor = Monitor());

/// Leaves at most `most` points, and sets the flatness threshold, and the cell size where that does not lead there.
/// Throws InputError where no cell size leaves so few, and as SimplifyElaborate does. At most 12 runs of that, and
/// about as many as the cell size has binary digits, three times.
Reduction SimplifyElaborateTo(
  std::size_t most, const BoundedHorizon& horizon, ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
