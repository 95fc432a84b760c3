// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMedian_h
#define SeismicHorizonsMedian_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Reorders the numbers, of which there is at least one. Of an even number the upper one of the two in the middle.
template <typename Number>
Number UpperMedian(std::vector<Number>& numbers)
{
  const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}
}

#endif
