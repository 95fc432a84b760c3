// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnOrder_h
#define SeismicHorizonsColumnOrder_h

#include "Common/Types.h"
#include "PickTable.h"
#include "PlacementOptions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A column whose picks differ in z.
struct ColumnConflict
{
  PlanePoint Column;
  double Difference = 0.0; // from the least z to the largest
};

/// Picks of a horizon.
struct ColumnOrder
{
  std::vector<std::int32_t> Picks;
  std::int64_t Duplicates = 0; // left out because another pick is in their column
  std::int64_t Repeats = 0; // of these, with the same z as another one in the column
  std::vector<ColumnConflict> Conflicts; // where others were left out, by ascending j and then i
  std::int64_t Nulls = 0; // left out because they have no z
};

/// The picks of each horizon that have a z, in the order they come.
std::vector<ColumnOrder> ListPicks(const PickTable& picks);

/// Orders the picks of a horizon, of each of which the column is given, by ascending j and then i, one for each column.
/// Of several in one column the policy of the options says which stays; where it asks for amplitudes and there is no
/// attribute of that name, the topmost does. For sheets all of different z stay, the topmost of a column first. For the
/// mean the topmost stays, with z and attributes that are the means of all in its column.
void OrderPicks(
  ColumnOrder& order, PickTable& picks, const std::vector<PlanePoint>& columns, const PlacementOptions& options);

/// The picks of each sheet (Common/ColumnSheets.h) of a horizon that is ordered for them, at least one. What was left
/// out is counted by the first.
std::vector<ColumnOrder> SplitIntoSheets(
  ColumnOrder order, const PickTable& picks, const std::vector<PlanePoint>& columns);
}

#endif
