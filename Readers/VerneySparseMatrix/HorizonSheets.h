// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sheets of a horizon that lies above itself, as at reverse faults. Voxels of neighbouring columns (eight around each)
// belong together when neither has a nearer one in the column of the other. Where a column has several voxels, each is
// on a layer of its own; layers join the single surface around them, those with the most contacts first, as long as no
// sheet comes to lie above itself. What is left becomes further sheets, as few as possible: parts that are not above
// each other share one.
//
//       o o o o
//   o o o . . . . . .        the first sheet: the single surface with the layer above,
//         x x o o o o        which has more contacts; the second sheet: x

#ifndef SeismicHorizonsHorizonSheets_h
#define SeismicHorizonsHorizonSheets_h

#include "Common/HorizonVoxels.h"

#include <vector>

namespace SeismicHorizons
{
/// The sheets of a horizon whose voxels stand column by column, by ascending j and then i, with any number in each: the
/// largest part is on the first. Each has at most one voxel in a column. What would take more than 64 sheets, and what
/// lies above its own part, is dropped, which the first sheet counts. Time of order n log n.
std::vector<HorizonVoxels> SplitIntoSheets(HorizonVoxels voxels);
}

#endif
