// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightNoise.h"

#include "ColumnIndex.h"
#include "Median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t LongestStride = 32;

struct Differences
{
  std::vector<double> Second; // Absolute values.
  double LeastStep = 1.0; // Between neighbours.
};

/// The golden ratio spreads the sample, since noise may repeat with the rows.
std::vector<std::size_t> SamplePoints(std::size_t points)
{
  constexpr std::size_t enough = 100000;
  constexpr double golden = 0.6180339887498949;
  const std::size_t group = points / enough + 1;
  std::vector<std::size_t> sample;
  double part = 0.0;
  for (std::size_t first = 0; first < points; first += group)
  {
    part = part + golden < 1.0 ? part + golden : part + golden - 1.0;
    sample.push_back(std::min(first + std::size_t(part * double(group)), points - 1));
  }
  return sample;
}

/// Uses the least stride at which one in a hundred points has both neighbours.
Differences Measure(const ColumnIndex& index, const std::vector<double>& heights, const PlanePoint& axis, double digits)
{
  const PlanePoints columns = index.Columns();
  const std::vector<std::size_t> sample = SamplePoints(columns.size());
  Differences found;
  for (std::int32_t stride = 1; stride <= LongestStride && 100 * found.Second.size() < sample.size(); ++stride)
  {
    found = Differences();
    for (const std::size_t point : sample)
    {
      const PlanePoint& column = columns[point];
      const PointId before = index.PointAt({ column.X - stride * axis.X, column.Y - stride * axis.Y });
      const PointId after = index.PointAt({ column.X + stride * axis.X, column.Y + stride * axis.Y });
      if (before != NoPoint && after != NoPoint)
      {
        const double rise = heights[point] - heights[before];
        found.Second.push_back(std::abs(heights[after] - heights[point] - rise));
        found.LeastStep = std::abs(rise) > digits ? std::min(found.LeastStep, std::abs(rise)) : found.LeastStep;
      }
    }
  }
  return found;
}

/// Estimates the deviation from the median of second differences, which ignores spikes and steps, or from their root
/// mean square if that is less: medians of integers jump.
double NoiseOf(std::vector<double> sizes)
{
  if (sizes.empty())
  {
    return 0.0;
  }
  constexpr double deviationPerMedian = 1.4826;
  const double squares =
    std::accumulate(sizes.begin(), sizes.end(), 0.0, [](double sum, double size) { return sum + size * size; });
  const double deviation = std::min(deviationPerMedian * UpperMedian(sizes), std::sqrt(squares / double(sizes.size())));
  return deviation / std::sqrt(6.0); // Second differences have 1, -2 and 1 times the noise.
}
}

//----------------------------------------------------------------------------------------------------------------------
HeightNoise MeasureHeightNoise(PlanePoints columns, const std::vector<double>& heights)
{
  if (columns.empty())
  {
    return {};
  }
  const double digits = 1e-6 * // Single precision.
    std::abs(
      *std::max_element(heights.begin(), heights.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const ColumnIndex index(columns, 1, LongestStride);
  const Differences alongX = Measure(index, heights, { 1, 0 }, digits);
  const Differences alongY = Measure(index, heights, { 0, 1 }, digits);
  const double rounding = std::min(alongX.LeastStep, alongY.LeastStep) / std::sqrt(12.0);
  const double noise = std::max(NoiseOf(alongX.Second), NoiseOf(alongY.Second));
  return { std::max(noise, rounding), noise <= rounding };
}
}
