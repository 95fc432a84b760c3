// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults through holes. Nothing can be detected where columns are missing, so that a fault across a hole is found as
// two lines, and filling would create a ramp. Two lines that end at a hole are joined if they point at each other and
// have similar throws.

#ifndef SeismicHorizonsFaultJoins_h
#define SeismicHorizonsFaultJoins_h

#include "ColumnHeights.h"
#include "FaultLines.h"

namespace SeismicHorizons
{
/// Appends a curved line for each pair; at least half of its columns are missing. Throws and heights are
/// interpolated there. Each end is joined once, straightest pairs first.
void JoinThroughHoles(const ColumnHeights& heights, FaultLines& lines);
}

#endif
