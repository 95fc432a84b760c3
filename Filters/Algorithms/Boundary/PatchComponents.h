// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What hangs together when each point reaches all columns that are at most k away along each axis (SN_k components).

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "ColumnRaster.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// A union-find forest whose roots are the least numbers of their sets.
class DisjointSets
{
public:
  std::int32_t Add()
  {
    this->Parent.push_back(std::int32_t(this->Parent.size()));
    return this->Parent.back();
  }

  std::int32_t Find(std::int32_t member)
  {
    while (this->Parent[std::size_t(member)] != member)
    {
      std::int32_t& parent = this->Parent[std::size_t(member)];
      parent = this->Parent[std::size_t(parent)];
      member = parent;
    }
    return member;
  }

  /// False when the two are in one set already.
  bool Join(std::int32_t a, std::int32_t b)
  {
    const std::int32_t rootA = this->Find(a);
    const std::int32_t rootB = this->Find(b);
    this->Parent[std::size_t(rootA < rootB ? rootB : rootA)] = rootA < rootB ? rootA : rootB;
    return rootA != rootB;
  }

private:
  std::vector<std::int32_t> Parent;
};

struct PatchComponents
{
  /// For each point the number of its component. Components are numbered in the order in which the rows of the lattice,
  /// from the least y, meet them.
  std::vector<std::int32_t> Component;
  /// For each component the place in the raster where that is.
  std::vector<std::int64_t> First;
};

/// Linear in the places of the raster, with a factor of k in the runs of its rows.
PatchComponents FindPatchComponents(const ColumnRaster& raster, std::size_t points, int radius);
}

#endif
