// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over chunks of fixed size, whatever the number of threads: what is begun anew with each chunk, and what is
// added up chunk by chunk, is then the same for any number of them.

#ifndef SeismicHorizonsFixedChunks_h
#define SeismicHorizonsFixedChunks_h

#include "Parallel.h"

#include <algorithm>
#include <cstdint>

namespace SeismicHorizons
{
inline std::size_t CountChunks(std::int64_t size, std::int64_t chunkSize)
{
  return std::size_t((size + chunkSize - 1) / chunkSize);
}

/// Calls work(chunk, first, last) for all chunks of 0 to `size`, on several threads.
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
}

#endif
