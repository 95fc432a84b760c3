// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over chunks whose size does not depend on the number of threads. A sum of real numbers depends on the order in
// which they are added: added up within each chunk, and then chunk by chunk, it is the same for any number of threads.
// So are random numbers that start anew in each chunk.

#ifndef SeismicHorizonsFixedChunks_h
#define SeismicHorizonsFixedChunks_h

#include "Parallel.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// How many chunks it takes to hold `size` items. The last one may be smaller.
inline std::size_t CountChunks(std::int64_t size, std::int64_t chunkSize)
{
  return std::size_t((size + chunkSize - 1) / chunkSize);
}

/// Calls work(chunk, first, last) for each chunk of the indices 0 to `size`, `last` not included, on several threads.
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

/// Calls work(part, first, last) for each chunk of the indices 0 to `size`, on several threads, with a part of its own
/// for each, and adds the parts up in their order: `Sums` begins with nothing, and has a function Add for another one.
template <typename Sums, typename Work>
Sums AddUpChunks(std::int64_t size, std::int64_t chunkSize, const Monitor& monitor, Work&& work)
{
  std::vector<Sums> parts(CountChunks(size, chunkSize));
  ForEachChunk(size, chunkSize, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      Sums part;
      work(part, first, last);
      parts[chunk] = part;
    });
  Sums all;
  for (const Sums& part : parts)
  {
    all.Add(part);
  }
  return all;
}
}

#endif
