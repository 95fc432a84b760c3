// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsParallelSort_h
#define SeismicHorizonsParallelSort_h

#include "FixedChunks.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Sorts by a total order. Chunks are sorted, then merged in pairs.
template <typename Item, typename Precedes>
void ParallelSort(std::vector<Item>& items, const Precedes& precedes)
{
  constexpr std::int64_t ItemsPerChunk = 4096;
  const auto size = std::int64_t(items.size());
  ForEachChunk(size, ItemsPerChunk, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    { std::sort(items.begin() + first, items.begin() + last, precedes); });
  for (std::int64_t sorted = ItemsPerChunk; sorted < size; sorted *= 2)
  {
    ForEachChunk(size, 2 * sorted, Monitor(),
      [&](std::size_t, std::int64_t first, std::int64_t last)
      {
        const std::int64_t middle = std::min(first + sorted, last);
        std::inplace_merge(items.begin() + first, items.begin() + middle, items.begin() + last, precedes);
      });
  }
}
}

#endif
