// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnOrder_h
#define SeismicHorizonsColumnOrder_h

#include "Common/Horizon/Types.h"
#include "PickTable.h"
#include "PlacementOptions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct ColumnConflict
{
  PlanePoint Column;
  double Difference = 0.0;
};

struct ColumnOrder
{
  std::vector<std::int32_t> Picks;
  std::int64_t Duplicates = 0; // Picks dropped for another pick in their column.
  std::int64_t Repeats = 0; // Dropped picks with the z of another pick in the column.
  std::vector<ColumnConflict> Conflicts; // By ascending j, then i.
  std::int64_t Nulls = 0; // Picks dropped for lack of z.
};

std::vector<ColumnOrder> ListPicks(const PickTable& picks);

/// Sorts by ascending j, then i, and resolves duplicates. Without amplitudes the topmost pick replaces the strongest.
/// Sheets keep all picks of different z, the topmost first. The topmost pick gets the mean.
void OrderPicks(
  ColumnOrder& order, PickTable& picks, const std::vector<PlanePoint>& columns, const PlacementOptions& options);

/// There is at least one sheet; the first counts the dropped picks.
std::vector<ColumnOrder> SplitIntoSheets(
  ColumnOrder order, const PickTable& picks, const std::vector<PlanePoint>& columns);
}

#endif
