// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a horizon in columns without a point, by linear interpolation.

#ifndef SeismicHorizonsGapHeights_h
#define SeismicHorizonsGapHeights_h

#include "Common/LinkCuts.h"
#include "Common/Types.h"
#include "CommonColumns.h"

#include <vector>

namespace SeismicHorizons
{
/// Puts a height in where there is nan: along lines through a column, between the nearest columns with a height, so that
/// planes continue. What was found is used for columns that have none yet, and where only one side has a height, that
/// is taken. Lines go around cuts, which may be null. nan stays where there is no height far and wide.
void FillGaps(const HorizonView& horizon, const LinkCuts* cuts, PlanePoints columns, std::vector<double>& heights);
}

#endif
