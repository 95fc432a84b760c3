// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SheetBlocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace SeismicHorizons
{
namespace
{
using AlongAxes = std::array<std::int64_t, 2>;

constexpr int LargestGap = 64; ///< Columns.

/// Returns the median distance from a column to the next known one of its line: 1, unless only every few are known.
int FindGap(const std::vector<char>& isKnown, const AlongAxes& size, int along)
{
  const std::int64_t step = along == 0 ? 1 : size[0], across = along == 0 ? size[0] : 1;
  std::array<std::int64_t, LargestGap + 1> gaps{};
  for (std::int64_t line = 0; line < size[std::size_t(1 - along)]; ++line)
  {
    std::int64_t last = -1;
    for (std::int64_t n = 0; n < size[std::size_t(along)]; ++n)
    {
      if (isKnown[std::size_t(line * across + n * step)])
      {
        ++gaps[std::size_t(last < 0 ? 0 : std::min<std::int64_t>(LargestGap, n - last))];
        last = n;
      }
    }
  }
  std::int64_t all = 0, sum = 0;
  std::for_each(gaps.begin() + 1, gaps.end(), [&](std::int64_t count) { all += count; });
  int gap = 1;
  for (; gap < LargestGap && 2 * (sum += gaps[std::size_t(gap)]) < all; ++gap)
  {
  }
  return gap;
}
}

//----------------------------------------------------------------------------------------------------------------------
bool ChooseShown(vtkIdType numberOfPoints, int step, SheetBlocks& blocks)
{
  AlongAxes last = { std::numeric_limits<int>::min(), std::numeric_limits<int>::min() };
  blocks.First = { std::numeric_limits<int>::max(), std::numeric_limits<int>::max() };
  for (vtkIdType n = 0; n < 2 * numberOfPoints; ++n)
  {
    const std::size_t axis = n % 2;
    blocks.First[axis] = std::min<std::int64_t>(blocks.First[axis], blocks.Columns[n]);
    last[axis] = std::max<std::int64_t>(last[axis], blocks.Columns[n]);
  }
  const AlongAxes size = { last[0] - blocks.First[0] + 1, last[1] - blocks.First[1] + 1 };
  constexpr double mostPerPoint = 100.0, most = 5e8; // Columns; few of random picks are known.
  if (std::min(size[0], size[1]) < 2 ||
    double(size[0]) * double(size[1]) > std::min(most, mostPerPoint * double(numberOfPoints)))
  {
    return false;
  }
  std::vector<char> isKnown(std::size_t(size[0] * size[1]));
  std::int64_t known = 0;
  for (vtkIdType n = 0; n < numberOfPoints; ++n)
  {
    char& here = isKnown[std::size_t(
      (blocks.Columns[2 * n + 1] - blocks.First[1]) * size[0] + blocks.Columns[2 * n] - blocks.First[0])];
    known += here == 0 ? 1 : 0;
    here = 1;
  }
  constexpr std::int64_t mostDuplicates = 50; // One in so many points; two surfaces have more.
  if ((numberOfPoints - known) * mostDuplicates > numberOfPoints)
  {
    return false;
  }
  for (const std::size_t axis : { 0, 1 })
  {
    blocks.Step[axis] = step * FindGap(isKnown, size, int(axis));
    blocks.Count[axis] = (size[axis] - 1) / blocks.Step[axis] + 1;
  }
  blocks.Shown.assign(std::size_t(blocks.Count[0] * blocks.Count[1]), -1);
  const auto offset = [&](vtkIdType n)
  {
    const std::int64_t i = (blocks.Columns[2 * n] - blocks.First[0]) % blocks.Step[0] - blocks.Step[0] / 2;
    const std::int64_t j = (blocks.Columns[2 * n + 1] - blocks.First[1]) % blocks.Step[1] - blocks.Step[1] / 2;
    return i * i + j * j;
  };
  std::int64_t used = 0;
  for (vtkIdType n = 0; n < numberOfPoints; ++n)
  {
    const AlongAxes block = blocks.Find(blocks.Columns[2 * n], blocks.Columns[2 * n + 1]);
    vtkIdType& shown = blocks.Shown[std::size_t(block[1] * blocks.Count[0] + block[0])];
    used += shown < 0 ? 1 : 0;
    shown = shown < 0 || offset(n) < offset(shown) ? n : shown;
  }
  return numberOfPoints <= 2 * used * step * step;
}
}
