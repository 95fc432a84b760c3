// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points that are drawn of a large horizon.

#ifndef SheetBlocks_h
#define SheetBlocks_h

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Blocks of columns; one point of each block is shown.
struct SheetBlocks
{
  const int* Columns = nullptr; ///< Of all points.
  std::array<std::int64_t, 2> First = {};
  std::array<std::int64_t, 2> Step = { 1, 1 }; ///< Columns of a block.
  std::array<std::int64_t, 2> Count = {};
  std::vector<vtkIdType> Shown; ///< A point per block, or -1.
  std::vector<std::array<double, 3>> Places; ///< Of points of the sheet.

  std::array<std::int64_t, 2> Find(std::int64_t i, std::int64_t j) const
  {
    return { (i - this->First[0]) / this->Step[0], (j - this->First[1]) / this->Step[1] };
  }
  vtkIdType At(std::int64_t i, std::int64_t j) const
  {
    return i >= 0 && j >= 0 && i < this->Count[0] && j < this->Count[1]
      ? this->Shown[std::size_t(j * this->Count[0] + i)]
      : -1;
  }
};

/// In each block the point nearest to its middle is shown; a block is `step` times as wide as the usual distance of
/// known columns. Returns false if blocks have points at random, or columns several.
bool ChooseShown(vtkIdType numberOfPoints, int step, SheetBlocks& blocks);
}

#endif
