// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnOrder_h
#define SeismicHorizonsColumnOrder_h

#include "PickTable.h"
#include "PlacementOptions.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// The column of each pick.
struct ColumnList
{
  std::vector<int> I, J;
};

/// The picks of a horizon, by ascending j and then i, one for each column.
struct ColumnOrder
{
  std::vector<std::int32_t> Picks;
  std::int64_t Duplicates = 0; // left out because another pick is in their column
  std::int64_t Nulls = 0; // left out because they have no z
};

/// Orders the picks of horizon `number`. Of several in one column the policy of the options says which stays; where it
/// asks for amplitudes and there is no attribute of that name, the topmost does.
ColumnOrder OrderPicks(const PickTable& picks, int number, const ColumnList& columns, const PlacementOptions& options);
}

#endif
