// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums depend on the order of addition. Sums within chunks of fixed size, added in the order of chunks, do not depend
// on the number of threads, nor do random numbers that restart in each chunk.

#ifndef SeismicHorizonsFixedChunks_h
#define SeismicHorizonsFixedChunks_h

#include "Parallel.h"
#include "RawVector.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
constexpr std::int64_t ChunkSize = 1 << 16; // items per chunk in loops with little work per item

inline std::size_t CountChunks(std::int64_t size, std::int64_t chunkSize)
{
  return std::size_t((size + chunkSize - 1) / chunkSize);
}

template <typename Work>
void ForEachChunk(std::int64_t size, std::int64_t chunkSize, const Monitor& monitor, Work&& work)
{
  ParallelFor(std::int64_t(CountChunks(size, chunkSize)), 1, monitor,
    [&](std::int64_t firstChunk, std::int64_t lastChunk)
    {
      for (std::int64_t chunk = firstChunk; chunk < lastChunk; ++chunk)
      {
        work(std::size_t(chunk), chunk * chunkSize, std::min(size, (chunk + 1) * chunkSize));
      }
    });
}

/// Calls work(part, first, last) with a part per chunk, and adds the parts in order by Sums::Add.
template <typename Sums, typename Work>
Sums AddUpChunks(std::int64_t size, std::int64_t chunkSize, const Monitor& monitor, Work&& work)
{
  std::vector<Sums> parts(CountChunks(size, chunkSize));
  ForEachChunk(size, chunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      Sums part;
      work(part, first, last);
      parts[chunk] = std::move(part);
    });
  Sums all;
  for (const Sums& part : parts)
  {
    all.Add(part);
  }
  return all;
}

/// Calls work(items, first, last) with a list per chunk, and returns the lists one after the other.
template <typename Item, typename Work>
std::vector<Item> CollectChunks(std::int64_t size, std::int64_t chunkSize, const Monitor& monitor, Work&& work)
{
  std::vector<std::vector<Item>> parts(CountChunks(size, chunkSize));
  ForEachChunk(size, chunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last) { work(parts[chunk], first, last); });
  std::vector<Item> all;
  for (const std::vector<Item>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Returns equal items.
template <typename Item>
RawVector<Item> FilledVector(std::size_t size, const Item& value)
{
  RawVector<Item> items(size);
  ForEachChunk(std::int64_t(size), ChunkSize, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    { std::fill(items.begin() + first, items.begin() + last, value); });
  return items;
}

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
