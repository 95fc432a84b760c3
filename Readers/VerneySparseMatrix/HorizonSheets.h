// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSheets_h
#define SeismicHorizonsHorizonSheets_h

#include "Common/HorizonVoxels.h"

#include <vector>

namespace SeismicHorizons
{
/// The sheets (Common/ColumnSheets.h) of a horizon whose voxels stand column by column, by ascending j and then i, with
/// any number in each. The first sheet counts the voxels that are dropped.
std::vector<HorizonVoxels> SplitIntoSheets(HorizonVoxels voxels);
}

#endif
