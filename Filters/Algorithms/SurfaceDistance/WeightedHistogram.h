// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Percentiles of any number of values in little memory.

#ifndef SeismicHorizonsWeightedHistogram_h
#define SeismicHorizonsWeightedHistogram_h

#include <cstdint>
#include <mutex>
#include <vector>

namespace SeismicHorizons
{
/// Adds up the weights of values that are not negative, in bins that are at most 1/1024 of the value wide, from 2^-64
/// to 2^64. What is smaller counts as 0, what is larger as infinite. Weights are integers, so that their sums do not
/// depend on the order, and thus not on the number of threads.
class WeightedHistogram
{
public:
  WeightedHistogram();

  /// A value on its way into the histogram.
  struct Entry
  {
    std::uint32_t Bin;
    std::uint64_t Weight;
  };

  static Entry MakeEntry(double value, std::uint64_t weight) { return { BinOf(value), weight }; }

  /// Adds all entries and clears the list. Any thread may call it.
  void Add(std::vector<Entry>& entries);
  void Add(const WeightedHistogram& other);

  /// The value below which a part of the weight lies, 0 to 1; right to 1/1024 of the value. Nan when there is no
  /// weight.
  double Percentile(double part) const;

private:
  static std::uint32_t BinOf(double value);
  static double LowEnd(std::size_t bin);

  std::mutex Mutex;
  std::vector<std::uint64_t> Weights;
};
}

#endif
