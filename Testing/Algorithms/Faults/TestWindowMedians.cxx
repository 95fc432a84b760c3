// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Medians of windows, beside sorting the numbers of each: in long rows, short ones, and with numbers missing.

#include "Filters/Algorithms/Faults/WindowMedians.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Rows = std::array<const float*, WindowSide>;

/// Nan where the window has no number.
float SortedMedian(const Rows& rows, std::int64_t width, std::int64_t x)
{
  std::vector<float> numbers;
  for (const float* const row : rows)
  {
    for (std::int64_t at = std::max<std::int64_t>(0, x - WindowReach); at <= std::min(width - 1, x + WindowReach); ++at)
    {
      if (!std::isnan(row[at]))
      {
        numbers.push_back(row[at]);
      }
    }
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers.empty() ? std::numeric_limits<float>::quiet_NaN() : numbers[(numbers.size() - 1) / 2];
}

/// Numbers of which a part is missing: whole ones, with many that are equal, or others.
void CheckRows(std::int64_t width, double missing, bool areWhole)
{
  Patches::Random random(std::uint64_t(width) + (areWhole ? 1000 : 0));
  std::vector<float> numbers(std::size_t(width * WindowSide));
  for (float& number : numbers)
  {
    number = float(areWhole ? random.Below(5) - 2 : 10.0 * random.Fraction() - 5.0);
    number = random.Chance(missing) ? std::numeric_limits<float>::quiet_NaN() : number;
  }
  Rows rows;
  for (std::int64_t row = 0; row < WindowSide; ++row)
  {
    rows[std::size_t(row)] = numbers.data() + row * width;
  }
  std::vector<float> medians(std::size_t(width), 0.0F);
  FindWindowMedians(rows, width, medians.data());
  for (std::int64_t x = 0; x < width; ++x)
  {
    const float expected = SortedMedian(rows, width, x);
    if (!std::isnan(expected))
    {
      CHECK_EQUAL(medians[std::size_t(x)], expected);
    }
  }
}
}

int TestWindowMedians(int, char*[])
{
  for (const std::int64_t width : { 1, 3, 7, 63, 64, 65, 122, 123, 300, 1000 })
  {
    for (const bool areWhole : { false, true })
    {
      CheckRows(width, 0.0, areWhole);
      CheckRows(width, 0.002, areWhole);
      CheckRows(width, 0.3, areWhole);
    }
  }
  return Check::Result();
}
