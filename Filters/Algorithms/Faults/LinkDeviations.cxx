// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinkDeviations.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Reach = 3; // columns
constexpr std::int64_t Side = 2 * Reach + 1;

/// The differences across the links of some rows, each row with a margin of nan on both sides. Rows come one after the
/// other, and the last seven are kept.
class DifferenceRows
{
public:
  DifferenceRows(const ColumnHeights& heights, LinkSide side)
    : Heights(heights)
    , Kind(side)
    , Width(heights.Grid().Width() + 2 * Reach)
    , Values(std::size_t(Side * this->Width), std::numeric_limits<float>::quiet_NaN())
  {
  }

  /// The row y, which may lie outside the box.
  void Load(std::int64_t y)
  {
    const LinkGrid& grid = this->Heights.Grid();
    const bool isEast = this->Kind == LinkSide::East;
    float* const row = this->Row(y);
    std::fill(row - Reach, row - Reach + this->Width, std::numeric_limits<float>::quiet_NaN());
    if (y < 0 || y + (isEast ? 0 : 1) >= grid.Height())
    {
      return;
    }
    const double* const before = this->Heights.Row(y);
    const double* const beyond = isEast ? before + 1 : this->Heights.Row(y + 1);
    for (std::int64_t x = 0; x < grid.Width() - (isEast ? 1 : 0); ++x)
    {
      row[x] = float(beyond[x] - before[x]);
    }
  }

  /// The first column of a row that is kept.
  float* Row(std::int64_t y) { return this->Values.data() + (y + Side) % Side * this->Width + Reach; }

private:
  const ColumnHeights& Heights;
  const LinkSide Kind;
  const std::int64_t Width;
  std::vector<float> Values;
};

/// The numbers of seven rows at one place, ascending; those that are nan are left out.
struct SortedFile
{
  std::array<float, std::size_t(Side)> Values;
  int Size = 0;

  void Insert(float value)
  {
    int place = this->Size++;
    for (; place > 0 && this->Values[std::size_t(place - 1)] > value; --place)
    {
      this->Values[std::size_t(place)] = this->Values[std::size_t(place - 1)];
    }
    this->Values[std::size_t(place)] = value;
  }
};

/// The numbers of seven files, ascending. From a place to the next one file leaves, and one comes: both are sorted, so
/// that it takes one pass, some times less than to look for the median anew.
class SortedWindow
{
public:
  void Replace(const SortedFile& leaving, const SortedFile& coming)
  {
    std::array<float, std::size_t(Side * Side)> next;
    std::size_t size = 0;
    int left = 0;
    int came = 0;
    for (std::size_t n = 0; n < this->Size; ++n)
    {
      const float value = this->Values[n];
      if (left < leaving.Size && leaving.Values[std::size_t(left)] == value)
      {
        ++left;
        continue;
      }
      while (came < coming.Size && coming.Values[std::size_t(came)] < value)
      {
        next[size++] = coming.Values[std::size_t(came++)];
      }
      next[size++] = value;
    }
    while (came < coming.Size)
    {
      next[size++] = coming.Values[std::size_t(came++)];
    }
    std::copy(next.begin(), next.begin() + std::ptrdiff_t(size), this->Values.begin());
    this->Size = size;
  }

  /// Of an even number the lower one of the two in the middle. There must be one.
  float Median() const { return this->Values[(this->Size - 1) / 2]; }

private:
  std::array<float, std::size_t(Side* Side)> Values = {};
  std::size_t Size = 0;
};

/// The deviations of a row, one for every other place: those of the other side come between.
void FindRow(DifferenceRows& differences, std::int64_t y, std::int64_t width, float* deviations)
{
  std::array<const float*, std::size_t(Side)> rows;
  for (std::int64_t n = 0; n < Side; ++n)
  {
    rows[std::size_t(n)] = differences.Row(y - Reach + n);
  }
  const float* const row = rows[std::size_t(Reach)];
  std::array<SortedFile, std::size_t(Side)> files; // of the places x - 3 to x + 3, in a ring
  SortedWindow window;
  for (std::int64_t x = -2 * Reach; x < width; ++x)
  {
    SortedFile coming;
    for (const float* const values : rows)
    {
      const float value = x + Reach >= 0 ? values[x + Reach] : values[-1]; // which is nan
      if (!std::isnan(value))
      {
        coming.Insert(value);
      }
    }
    SortedFile& oldest = files[std::size_t((x + 2 * Reach) % Side)];
    window.Replace(oldest, coming);
    oldest = coming;
    if (x >= 0)
    {
      deviations[2 * x] = std::isnan(row[x]) ? row[x] : row[x] - window.Median();
    }
  }
}

// The standard deviation of normal noise by the median and by the mean of its sizes.
constexpr double DeviationPerMedian = 1.4826;
constexpr double DeviationPerMean = 1.2533;
// What rounding to whole heights does to a difference: the square root of two twelfths.
constexpr double WholeFloor = 0.408;
constexpr double RealFloor = 0.02;

/// The median of whole numbers, were each spread evenly from half below it to half above it; `median` is that of the
/// numbers as they are. So it changes with their distribution, and does not leap from 0 to 1.
double GroupedMedian(const std::vector<float>& sizes, float median)
{
  std::size_t below = 0;
  std::size_t equal = 0;
  for (const float size : sizes)
  {
    const float whole = std::round(size);
    below += whole < median ? 1 : 0;
    equal += whole == median ? 1 : 0;
  }
  const double part = (0.5 * double(sizes.size()) - double(below)) / double(equal);
  return median == 0.0F ? 0.5 * part : double(median) - 0.5 + part;
}

double ClippedMean(const std::vector<float>& sizes, double largest)
{
  double sum = 0.0;
  for (const float size : sizes)
  {
    sum += std::min(double(size), largest);
  }
  return sum / double(sizes.size());
}
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<float> FindDeviations(const ColumnHeights& heights, const Monitor& monitor)
{
  const LinkGrid& grid = heights.Grid();
  RawVector<float> deviations;
  deviations.resize(std::size_t(grid.NumberOfLinks()));
  constexpr std::int64_t Grain = 65536; // links that a thread takes at a time
  const std::int64_t rows = std::max<std::int64_t>(2 * Reach, Grain / grid.Width());
  ParallelFor(grid.Height(), rows, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (const LinkSide side : { LinkSide::East, LinkSide::North })
      {
        DifferenceRows differences(heights, side);
        for (std::int64_t y = first - Reach; y < first + Reach; ++y)
        {
          differences.Load(y);
        }
        for (std::int64_t y = first; y < last; ++y)
        {
          differences.Load(y + Reach);
          FindRow(differences, y, grid.Width(), deviations.data() + grid.LinkOf(0, y, side));
        }
      }
    });
  return deviations;
}

//----------------------------------------------------------------------------------------------------------------------
double MeasureNoise(const RawVector<float>& deviations, bool areHeightsWhole)
{
  // A million values tell as well as all.
  constexpr std::size_t Enough = 1000000;
  // Odd, so that links of both sides are among them.
  const std::size_t step = (deviations.size() / Enough) | 1;
  std::vector<float> sizes;
  for (std::size_t n = 0; n < deviations.size(); n += step)
  {
    if (!std::isnan(deviations[n]))
    {
      sizes.push_back(std::abs(deviations[n]));
    }
  }
  const double floor = areHeightsWhole ? WholeFloor : RealFloor;
  if (sizes.empty())
  {
    return floor;
  }
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (areHeightsWhole)
  {
    return std::max(floor, DeviationPerMedian * GroupedMedian(sizes, std::round(*middle)));
  }
  const double noise = DeviationPerMedian * double(*middle);
  return noise >= floor ? noise : std::max(floor, DeviationPerMean * ClippedMean(sizes, 4.0 * floor));
}
}
