// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Thresholds of a simplification of the inside that leave a given number of points (thesis 6.2):
//
//  rough       smallest cell size that does not exceed the number
//  elaborate   flatness threshold by bisection, to 3 % of the number; with larger cells if the largest threshold
//              leaves more, and with smaller cells if 0 leaves fewer
//
// Boundary points are always kept.

#ifndef SeismicHorizonsPointTarget_h
#define SeismicHorizonsPointTarget_h

#include "CellOptions.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"
#include "ElaborateSimplification.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Throws InputError if boundary points and one point per patch exceed `most`. Takes about 2 log2(cell size) runs.
Reduction SimplifyRoughTo(
  std::size_t most, const BoundedHorizon& horizon, CellOptions& options, const Monitor& monitor = Monitor());

/// The cell size changes if no threshold suffices. Takes at most about 12 + 3 log2(cell size) runs.
Reduction SimplifyElaborateTo(
  std::size_t most, const BoundedHorizon& horizon, ElaborateOptions& options, const Monitor& monitor = Monitor());
}

#endif
