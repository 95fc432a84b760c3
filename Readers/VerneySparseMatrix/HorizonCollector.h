// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonCollector_h
#define SeismicHorizonsHorizonCollector_h

#include "HorizonSorter.h"
#include "SparseMatrixParser.h"

#include <deque>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
/// Puts the horizons of blocks together, in the order of the blocks.
class HorizonCollector
{
public:
  /// Adds the horizons of the first `count` blocks, on all threads.
  void Add(const std::vector<HorizonSorter>& blocks, std::size_t count);

  /// All horizons of at least that many voxels, by ascending surface ID.
  std::vector<LatticeHorizon> Take(std::int64_t smallestSize);

private:
  LatticeHorizon& HorizonOf(int surfaceId);

  std::unordered_map<int, std::size_t> Positions; // by surface ID
  std::deque<LatticeHorizon> Horizons; // they stay where they are
};
}

#endif
