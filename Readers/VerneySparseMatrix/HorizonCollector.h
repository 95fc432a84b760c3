// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonCollector_h
#define SeismicHorizonsHorizonCollector_h

#include "SparseMatrixParser.h"

#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
/// Puts the horizons of blocks together, in the order of the blocks.
class HorizonCollector
{
public:
  /// Copies them.
  void Add(const std::vector<HorizonVoxels>& horizons);

  /// All horizons, by ascending surface ID.
  std::vector<HorizonVoxels> Take();

private:
  std::unordered_map<int, std::size_t> Positions; // by surface ID
  std::vector<HorizonVoxels> Horizons;
};
}

#endif
