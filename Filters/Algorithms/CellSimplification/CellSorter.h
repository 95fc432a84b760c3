// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts the points of a horizon into cells, on several threads.

#ifndef SeismicHorizonsCellSorter_h
#define SeismicHorizonsCellSorter_h

#include "Common/CellGrid.h"
#include "Common/Monitor.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Writes all points to `sorted`, cell by cell, in each cell in the order of the input; and to `begins`, which must be
/// 0 for every cell, where the points of each cell begin. There are less than 2^32 points and cells.
void SortIntoCells(const CellGrid& grid, const std::vector<PlanePoint>& plane, std::vector<std::uint32_t>& begins,
  PointId* sorted, const Monitor& monitor);
}

#endif
