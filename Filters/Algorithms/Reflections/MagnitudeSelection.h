// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Percentiles of absolute amplitudes, exactly and without a copy of them. As bits, positive floating point numbers have
// the order of their values: all are counted by their upper 16 bits, and then those whose upper bits are the wanted
// ones by their lower 16.

#ifndef SeismicHorizonsMagnitudeSelection_h
#define SeismicHorizonsMagnitudeSelection_h

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// Counts numbers that are at least 0, by half of their bits.
class MagnitudeCounts
{
public:
  /// Counts by the upper bits.
  MagnitudeCounts() = default;
  /// Counts those with these upper bits by their lower ones.
  explicit MagnitudeCounts(std::uint32_t upper)
    : Upper(upper)
    , CountsLower(true)
  {
  }

  void Add(float magnitude)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &magnitude, sizeof(bits));
    if (!this->CountsLower)
    {
      ++this->Counts[bits >> 16];
    }
    else if (bits >> 16 == this->Upper)
    {
      ++this->Counts[bits & 0xFFFFU];
    }
  }

  void Merge(const MagnitudeCounts& other)
  {
    for (std::size_t key = 0; key < this->Counts.size(); ++key)
    {
      this->Counts[key] += other.Counts[key];
    }
  }

  std::int64_t Total() const;

  /// The bits of the number that has `rank` smaller ones before it; `rank` becomes its rank among those of the same
  /// bits.
  std::uint32_t Find(std::int64_t& rank) const;

private:
  std::uint32_t Upper = 0;
  bool CountsLower = false;
  std::vector<std::int64_t> Counts = std::vector<std::int64_t>(std::size_t(1) << 16, 0);
};

/// The smallest of some numbers that are at least 0 for which at least `percentile` percent of them are smaller, or the
/// largest; 0 where there are none. `count(counts)` adds all of them to the counts; it is called twice.
float SelectPercentile(double percentile, const std::function<void(MagnitudeCounts& counts)>& count);
}

#endif
