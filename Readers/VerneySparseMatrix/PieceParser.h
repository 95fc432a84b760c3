// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPieceParser_h
#define SeismicHorizonsPieceParser_h

#include "Common/LineBuffer.h"
#include "Common/Monitor.h"
#include "HorizonSorter.h"
#include "SparseMatrixParser.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Parses the lines of a file piece by piece, and each piece block by block on all threads.
class PieceParser
{
public:
  /// Takes the horizons of the first `count` blocks, in their order.
  using Taker = std::function<void(const std::vector<HorizonSorter>& blocks, std::size_t count)>;

  /// Begins at the line of a column.
  PieceParser(const SparseMatrixSize& size, const SparseMatrixOptions& options, std::int64_t firstColumn = 0)
    : Size(size)
    , Options(options)
    , Lines(firstColumn)
  {
  }

  /// Parses all pieces, as long as goOn(column) says so at the first column of a piece that was read.
  void ParseAll(
    LineBuffer& lines, const Monitor& monitor, const Taker& take, const std::function<bool(std::int64_t)>& goOn);

  /// Throws InputError when lines are missing at the end of the file.
  void RequireEnd() const;

private:
  void Parse(std::string_view lines, const Taker& take);
  std::vector<std::int64_t> CountLinesBefore(const std::vector<std::string_view>& blocks);

  const SparseMatrixSize Size;
  const SparseMatrixOptions Options;
  std::int64_t Lines; // parsed so far, and before the first one
  std::vector<HorizonSorter> Parsed; // for each block of a piece
};
}

#endif
