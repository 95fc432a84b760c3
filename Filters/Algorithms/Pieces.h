// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over pieces of fixed size, whatever the number of threads: what is begun anew with each piece, and what is
// added up piece by piece, is then the same for any number of them.

#ifndef SeismicHorizonsPieces_h
#define SeismicHorizonsPieces_h

#include "Parallel.h"

#include <algorithm>
#include <cstdint>

namespace SeismicHorizons
{
inline std::size_t CountPieces(std::int64_t size, std::int64_t pieceSize)
{
  return std::size_t((size + pieceSize - 1) / pieceSize);
}

/// Calls work(piece, first, last) for all pieces of 0 to `size`, on several threads.
template <typename Work>
void ForEachPiece(std::int64_t size, std::int64_t pieceSize, const Monitor& monitor, Work&& work)
{
  ParallelFor(std::int64_t(CountPieces(size, pieceSize)), 1, monitor,
    [&](std::int64_t firstPiece, std::int64_t lastPiece)
    {
      for (std::int64_t piece = firstPiece; piece < lastPiece; ++piece)
      {
        work(std::size_t(piece), piece * pieceSize, std::min(size, (piece + 1) * pieceSize));
      }
    });
}
}

#endif
