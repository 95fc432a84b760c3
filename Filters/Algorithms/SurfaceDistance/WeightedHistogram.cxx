// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WeightedHistogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr int LeastExponent = -64;
constexpr int GreatestExponent = 64;
constexpr std::uint32_t BinsPerOctave = 1024; // of equal width
// The first bin is that of 0, the last that of infinity.
constexpr std::uint32_t Bins = std::uint32_t(GreatestExponent - LeastExponent) * BinsPerOctave + 2;
}

//----------------------------------------------------------------------------------------------------------------------
WeightedHistogram::WeightedHistogram()
  : Weights(Bins, 0)
{
}

//----------------------------------------------------------------------------------------------------------------------
std::uint32_t WeightedHistogram::BinOf(double value)
{
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent); // from 1/2 to below 1
  if (value == 0.0 || exponent <= LeastExponent)
  {
    return 0;
  }
  if (!std::isfinite(value) || exponent > GreatestExponent)
  {
    return Bins - 1;
  }
  return 1 + std::uint32_t(exponent - 1 - LeastExponent) * BinsPerOctave +
    std::uint32_t((2.0 * fraction - 1.0) * BinsPerOctave);
}

//----------------------------------------------------------------------------------------------------------------------
double WeightedHistogram::LowEnd(std::size_t bin)
{
  const std::size_t octave = (bin - 1) / BinsPerOctave;
  const double fraction = 1.0 + double((bin - 1) % BinsPerOctave) / BinsPerOctave;
  return std::ldexp(fraction, int(octave) + LeastExponent);
}

//----------------------------------------------------------------------------------------------------------------------
void WeightedHistogram::Add(std::vector<Entry>& entries)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (const Entry& entry : entries)
  {
    this->Weights[entry.Bin] += entry.Weight;
  }
  entries.clear();
}

//----------------------------------------------------------------------------------------------------------------------
void WeightedHistogram::Add(const WeightedHistogram& other)
{
  std::transform(this->Weights.begin(), this->Weights.end(), other.Weights.begin(), this->Weights.begin(),
    [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

//----------------------------------------------------------------------------------------------------------------------
double WeightedHistogram::Percentile(double part) const
{
  const double wanted = part * double(std::accumulate(this->Weights.begin(), this->Weights.end(), std::uint64_t(0)));
  std::uint64_t below = 0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    const std::uint64_t weight = this->Weights[bin];
    if (weight > 0 && double(below + weight) >= wanted)
    {
      const double within = (wanted - double(below)) / double(weight);
      return bin == 0     ? 0.0
        : bin == Bins - 1 ? std::numeric_limits<double>::infinity()
                          : this->LowEnd(bin) + within * (this->LowEnd(bin + 1) - this->LowEnd(bin));
    }
    below += weight;
  }
  return std::numeric_limits<double>::quiet_NaN();
}
}
