// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The connected components of a horizon, where points at most k columns apart along each axis are connected (SN_k
// components of the thesis).

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "ColumnRaster.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Sets of the numbers from 0 that can be joined (a union-find forest). The least number of a set stands for it.
class DisjointSets
{
public:
  /// Adds a set of one number, the next one, and gives that.
  std::int32_t Add()
  {
    this->Parent.push_back(std::int32_t(this->Parent.size()));
    return this->Parent.back();
  }

  /// The number that stands for the set of another one.
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

  /// Joins the sets of two numbers. False when they are in one set already.
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
  /// For each component its first point in that order, as a place in the raster.
  std::vector<std::int64_t> First;
};

/// Takes time linear in the places of the raster, and in k times the number of runs in its rows.
PatchComponents FindPatchComponents(const ColumnRaster& raster, std::size_t points, int radius);
}

#endif
