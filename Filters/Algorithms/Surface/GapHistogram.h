// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far apart the points of a horizon are, and the radius of its boundary that follows.
//
//     a row of the lattice     #  #  #  .  #  .  .  #
//     its steps                 1  1   2      3

#ifndef SeismicHorizonsGapHistogram_h
#define SeismicHorizonsGapHistogram_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// How many steps of each length lead from a point of a row to the next one: [n] counts those of n columns, the last
/// entry all that are longer than LargestRadius.
using GapHistogram = std::array<std::int64_t, LargestRadius + 2>;

struct GapHistograms
{
  GapHistogram AlongRows = {};
  GapHistogram AlongColumns = {};
};

/// Linear in the points, and in the rows and columns of the lattice between the outermost ones; where these are far
/// more than points, n log n. 12 bytes per point and 24 per such row and column.
GapHistograms CountGaps(const std::vector<PlanePoint>& columns);

/// The least radius that spans 95 % of the steps along rows, and of those along columns; LargestRadius when none does.
/// Horizons with a point in every column have 99 % of their steps from neighbour to neighbour, whatever their outlines
/// and holes are like, and those on every n-th line none that is shorter than n; a radius for the last steps, too,
/// would bridge holes and bays.
int ChooseRadius(const std::vector<PlanePoint>& columns);
}

#endif
