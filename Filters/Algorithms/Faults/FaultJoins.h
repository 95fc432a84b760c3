// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults through holes. Where columns are missing nothing can be detected, so a fault that crosses a hole is found as
// two lines, and what is filled in between would be a ramp. Two lines that end at a hole become one fault when each
// points at the end of the other and their throws are alike.

#ifndef SeismicHorizonsFaultJoins_h
#define SeismicHorizonsFaultJoins_h

#include "ColumnHeights.h"
#include "FaultLines.h"

namespace SeismicHorizons
{
/// Appends a line from end to end for each pair, bent as their directions are. At least half of its columns are
/// missing. Throws and heights of its links change evenly from those of one line to those of the other where columns
/// are missing. Each end is joined once, the straightest pairs first.
void JoinThroughHoles(const ColumnHeights& heights, FaultLines& lines);
}

#endif
