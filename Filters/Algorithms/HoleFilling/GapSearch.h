// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The gaps of a horizon: groups of empty columns, connected side by side, that its patches enclose. They are the holes
// of its outline with a radius of 1.

#ifndef SeismicHorizonsGapSearch_h
#define SeismicHorizonsGapSearch_h

#include "Boundary/ColumnRaster.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Successive empty columns of a row, by places of the raster: at least one.
struct GapRun
{
  std::int64_t First;
  std::int64_t Last;
};

/// Gaps, numbered in the order in which the rows of the lattice, from the least y, meet them.
struct GapList
{
  std::size_t Size() const { return this->Columns.size(); }
  const GapRun* begin(std::size_t gap) const { return this->Runs.data() + (gap == 0 ? 0 : this->Ends[gap - 1]); }
  const GapRun* end(std::size_t gap) const { return this->Runs.data() + this->Ends[gap]; }

  std::vector<GapRun> Runs; // of all gaps one after the other, those of each row by row
  std::vector<std::size_t> Ends; // of the runs of each gap
  std::vector<std::int64_t> Columns; // how many each gap has
};

/// Takes time linear in the places of the raster, whose rim must be at least a column wide.
GapList FindGaps(const ColumnRaster& raster);
}

#endif
