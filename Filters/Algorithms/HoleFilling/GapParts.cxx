// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapParts.h"

#include "Common/DisjointSets.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::vector<std::vector<std::int64_t>> SplitGap(
  const ColumnRaster& raster, const RasterFrame& frame, const LinkCuts& cuts, const std::vector<std::int64_t>& gap)
{
  DisjointSets sets(gap.size());
  for (std::size_t n = 0; n < gap.size(); ++n)
  {
    const auto join = [&](std::int64_t place)
    {
      const auto found = std::lower_bound(gap.begin(), gap.begin() + std::ptrdiff_t(n), place);
      if (found != gap.begin() + std::ptrdiff_t(n) && *found == place)
      {
        sets.Join(std::int32_t(found - gap.begin()), std::int32_t(n));
      }
    };
    const std::int64_t west = gap[n] - 1;
    const std::int64_t south = gap[n] - raster.Width();
    if (!cuts.IsCutEast(frame.Column(west)))
    {
      join(west);
    }
    if (!cuts.IsCutNorth(frame.Column(south)))
    {
      join(south);
    }
  }
  std::vector<std::vector<std::int64_t>> parts;
  std::vector<std::size_t> number(gap.size());
  for (std::size_t n = 0; n < gap.size(); ++n)
  {
    const std::size_t root = std::size_t(sets.Find(std::int32_t(n)));
    if (root == n)
    {
      number[n] = parts.size();
      parts.emplace_back();
    }
    parts[number[root]].push_back(gap[n]);
  }
  return parts;
}
}
