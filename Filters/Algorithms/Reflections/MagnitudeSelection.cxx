// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MagnitudeSelection.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::int64_t MagnitudeCounts::Total() const
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(), std::int64_t(0));
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t MagnitudeCounts::Find(std::int64_t& rank) const
{
  std::uint32_t key = 0;
  while (rank >= this->Counts[key])
  {
    rank -= this->Counts[key++];
  }
  return key;
}

//----------------------------------------------------------------------------------------------------------------------
float SelectPercentile(double percentile, const std::function<void(MagnitudeCounts& counts)>& count)
{
  MagnitudeCounts upperCounts;
  count(upperCounts);
  const std::int64_t total = upperCounts.Total();
  if (total == 0)
  {
    return 0.0F;
  }
  std::int64_t rank = std::min(total - 1, std::int64_t(std::ceil(percentile / 100.0 * double(total))));
  const std::uint32_t upper = upperCounts.Find(rank);
  MagnitudeCounts lowerCounts(upper);
  count(lowerCounts);
  const std::uint32_t bits = upper << 16 | lowerCounts.Find(rank);
  float magnitude = 0.0F;
  std::memcpy(&magnitude, &bits, sizeof(bits));
  return magnitude;
}
}
