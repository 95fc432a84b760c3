// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sheets of a horizon that lies above itself, as at reverse faults. Points of neighbouring columns (eight around each)
// belong together when neither has a nearer one in the column of the other. Where a column has several points, each is
// on a layer of its own; layers join the single surface around them, those with the most contacts first, as long as no
// sheet comes to lie above itself. What is left becomes further sheets, as few as possible: parts that are not above
// each other share one.
//
//       o o o o
//   o o o . . . . . .        the first sheet: the single surface with the layer above,
//         x x o o o o        which has more contacts; the second sheet: x

#ifndef SeismicHorizonsColumnSheets_h
#define SeismicHorizonsColumnSheets_h

#include "Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
constexpr int MostSheets = 64;

/// The points of each sheet, by their numbers, ascending. There is at least one sheet; the largest part is on the
/// first.
struct ColumnSheets
{
  std::vector<std::vector<std::int32_t>> Points;
  std::int64_t Dropped = 0; // points on none of them
};

/// Splits points that stand column by column, by ascending j and then i, with any number in each, and are as many as
/// there are heights; those are finite, in any unit. Each sheet has at most one point in a column. Of a column with
/// more points than there can be sheets the first ones stay; besides, what lies above its own part is dropped, and what
/// would take a further sheet. Time of order n log n.
ColumnSheets SplitIntoSheets(PlanePoints columns, const std::vector<double>& heights);
}

#endif
