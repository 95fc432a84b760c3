// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VoxelExtent.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
VoxelExtent FindExtent(const HorizonVoxels& horizon)
{
  if (horizon.I.empty())
  {
    return EmptyExtent;
  }
  const auto i = std::minmax_element(horizon.I.begin(), horizon.I.end());
  const auto k = std::minmax_element(horizon.K.begin(), horizon.K.end());
  // Rows come one after the other.
  return { *i.first, *i.second, horizon.J.front(), horizon.J.back(), *k.first, *k.second };
}

//----------------------------------------------------------------------------------------------------------------------
VoxelExtent Unite(const VoxelExtent& a, const VoxelExtent& b)
{
  if (a == EmptyExtent || b == EmptyExtent)
  {
    return a == EmptyExtent ? b : a;
  }
  return { std::min(a[0], b[0]), std::max(a[1], b[1]), std::min(a[2], b[2]), std::max(a[3], b[3]), std::min(a[4], b[4]),
    std::max(a[5], b[5]) };
}

//----------------------------------------------------------------------------------------------------------------------
VoxelExtent WholeExtent(const SparseMatrixSize& size)
{
  return { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
}
}
