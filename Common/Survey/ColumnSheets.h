// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splits a horizon that lies above itself, as at reverse faults, into sheets. Points of neighbouring columns (eight
// around each) are connected when neither has a nearer one in the other column. Several points of a column form layers,
// which join the single surface around them, the most contacts first, as long as no sheet lies above itself. The rest
// becomes further sheets, as few as possible.
//
//       o o o o
//   o o o . . . . . .        the first sheet: the single surface with the layer above,
//         x x o o o o        which has more contacts; the second sheet: x

#ifndef SeismicHorizonsColumnSheets_h
#define SeismicHorizonsColumnSheets_h

#include "Common/Horizon/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
constexpr int MostSheets = 64;

/// Ascending indices per sheet. There is at least one sheet; the largest part is on the first.
struct ColumnSheets
{
  std::vector<std::vector<std::int32_t>> Points;
  std::int64_t Dropped = 0; // points on no sheet
};

/// Points must be sorted by j, then i; heights are finite. A sheet has at most one point per column; points
/// beyond the largest number of sheets are dropped. Time is of order n log n.
ColumnSheets SplitIntoSheets(PlanePoints columns, const std::vector<double>& heights);
}

#endif
