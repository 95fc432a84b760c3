// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GapHistogram.h"

#include "Boundary/EmptyBands.h"
#include "Common/CountingSort.h"
#include "Common/PlaneGeometry.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr double SpannedShare = 0.95; // of the steps along either axis

using Lines = ItemLists<std::int32_t, std::uint32_t>; // coordinates along each line of the lattice

/// The same points by lines across, in the order of the lines they came by.
Lines Turn(const Lines& lines, std::int64_t size, std::int64_t across)
{
  return Lines(across,
    [&](auto&& add)
    {
      for (std::int64_t line = 0; line < size; ++line)
      {
        std::for_each(lines.begin(line), lines.end(line), [&](std::int32_t place) { add(place, std::int32_t(line)); });
      }
    });
}

/// Of lines whose points are in order.
GapHistogram CountSteps(const Lines& lines, std::int64_t size)
{
  GapHistogram steps = {};
  for (std::int64_t line = 0; line < size; ++line)
  {
    for (const std::int32_t* place = lines.begin(line); place < lines.end(line) - 1; ++place)
    {
      ++steps[std::size_t(std::min(place[1] - place[0], LargestRadius + 1))];
    }
  }
  return steps;
}

GapHistograms Count(const std::vector<PlanePoint>& columns)
{
  const PlaneBox box(columns);
  const std::int64_t width = std::int64_t(box.Greatest.X) - box.Least.X + 1;
  const std::int64_t height = std::int64_t(box.Greatest.Y) - box.Least.Y + 1;
  const Lines unordered(width,
    [&](auto&& add)
    {
      for (const PlanePoint& column : columns)
      {
        add(column.X - box.Least.X, column.Y - box.Least.Y);
      }
    });
  const Lines rows = Turn(unordered, width, height);
  return { CountSteps(rows, height), CountSteps(Turn(rows, height, width), width) };
}

int LeastSpanning(const GapHistogram& steps)
{
  const std::int64_t all = std::accumulate(steps.begin(), steps.end(), std::int64_t(0));
  int radius = 1;
  std::int64_t spanned = steps[0] + steps[1];
  while (radius < LargestRadius && double(spanned) < SpannedShare * double(all))
  {
    spanned += steps[std::size_t(++radius)];
  }
  return radius;
}
}

//----------------------------------------------------------------------------------------------------------------------
GapHistograms CountGaps(const std::vector<PlanePoint>& columns)
{
  return columns.empty() ? GapHistograms() : WithoutWideBands(columns, LargestRadius, Count);
}

//----------------------------------------------------------------------------------------------------------------------
int ChooseRadius(const std::vector<PlanePoint>& columns)
{
  const GapHistograms gaps = CountGaps(columns);
  return std::max(LeastSpanning(gaps.AlongRows), LeastSpanning(gaps.AlongColumns));
}
}
