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
class HorizonCollector
{
public:
  void Add(const std::vector<HorizonSorter>& blocks, std::size_t count);

  /// Returns the horizons with enough voxels, by ascending surface ID.
  std::vector<LatticeHorizon> Take(std::int64_t smallestSize);

private:
  LatticeHorizon& HorizonOf(int surfaceId);

  std::unordered_map<int, std::size_t> Positions;
  std::deque<LatticeHorizon> Horizons;
};
}

#endif
