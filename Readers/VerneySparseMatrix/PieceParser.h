// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPieceParser_h
#define SeismicHorizonsPieceParser_h

#include "Common/Base/Monitor.h"
#include "Common/Text/LineBuffer.h"
#include "HorizonSorter.h"
#include "SparseMatrixParser.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
class PieceParser
{
public:
  /// Receives the horizons of the first `count` blocks, in their order.
  using Taker = std::function<void(const std::vector<HorizonSorter>& blocks, std::size_t count)>;

  PieceParser(const SparseMatrixSize& size, const SparseMatrixOptions& options, std::int64_t firstColumn = 0)
    : Size(size)
    , Options(options)
    , Lines(firstColumn)
  {
  }

  /// Stops when goOn(first column of a piece) is false.
  void ParseAll(
    LineBuffer& lines, const Monitor& monitor, const Taker& take, const std::function<bool(std::int64_t)>& goOn);

  void RequireEnd() const;

private:
  void Parse(std::string_view lines, const Taker& take);
  std::vector<std::int64_t> CountLinesBefore(const std::vector<std::string_view>& blocks);

  const SparseMatrixSize Size;
  const SparseMatrixOptions Options;
  std::int64_t Lines; // lines before the next piece
  std::vector<HorizonSorter> Parsed;
};

class HorizonCollector
{
public:
  /// With these voxels, about this part of all voxels is added; 0 if it is unknown.
  void Add(const std::vector<HorizonSorter>& blocks, std::size_t count, double partOfAll);

  /// Returns the horizons with enough voxels, by ascending surface ID.
  std::vector<LatticeHorizon> Take(std::int64_t smallestSize);

private:
  LatticeHorizon& HorizonOf(int surfaceId);

  std::unordered_map<int, std::size_t> Positions;
  std::deque<LatticeHorizon> Horizons;
};
}

#endif
