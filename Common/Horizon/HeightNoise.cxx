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
  const ColumnIndex index(columns, 1, LongestStride);
  NoiseSampler sampler(columns.size());
  do
  {
    sampler.Add(index, heights, 0, 0, columns.size());
  } while (!sampler.Finish());
  return sampler.Noise();
}

// ---- NoiseSampler ---------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
NoiseSampler::NoiseSampler(std::size_t points)
  : Sample(SamplePoints(points))
{
}

//----------------------------------------------------------------------------------------------------------------------
void NoiseSampler::Add(
  const ColumnIndex& index, const std::vector<double>& heights, std::size_t before, std::size_t first, std::size_t end)
{
  for (std::size_t point = first; point < end; ++point)
  {
    this->LargestHeight = std::max(this->LargestHeight, std::abs(heights[point - before]));
  }
  for (auto point = std::lower_bound(this->Sample.begin(), this->Sample.end(), first);
       point != this->Sample.end() && *point < end; ++point)
  {
    this->Measure(index, heights, before, *point, this->AlongX);
    this->Measure(index, heights, before, *point, this->AlongY);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void NoiseSampler::Measure(const ColumnIndex& index, const std::vector<double>& heights, std::size_t before,
  std::size_t point, Differences& along) const
{
  if (along.IsMeasured)
  {
    return;
  }
  const PlanePoint& column = index.Columns()[point - before];
  const PlanePoint step = { along.Stride * along.Axis.X, along.Stride * along.Axis.Y };
  const PointId last = index.PointAt({ column.X - step.X, column.Y - step.Y });
  const PointId next = index.PointAt({ column.X + step.X, column.Y + step.Y });
  if (last != NoPoint && next != NoPoint)
  {
    const double rise = heights[point - before] - heights[std::size_t(last)];
    along.Second.push_back(std::abs(heights[std::size_t(next)] - heights[point - before] - rise));
    along.Steps.push_back(std::abs(rise));
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool NoiseSampler::Finish()
{
  this->Widen(this->AlongX);
  this->Widen(this->AlongY);
  return this->AlongX.IsMeasured && this->AlongY.IsMeasured;
}

//----------------------------------------------------------------------------------------------------------------------
// The least stride is used at which one in a hundred points has both neighbours.
void NoiseSampler::Widen(Differences& along) const
{
  along.IsMeasured = along.Stride == LongestStride || 100 * along.Second.size() >= this->Sample.size();
  if (!along.IsMeasured)
  {
    ++along.Stride;
    along.Second.clear();
    along.Steps.clear();
  }
}

//----------------------------------------------------------------------------------------------------------------------
double NoiseSampler::LeastStep(const Differences& along) const
{
  const double digits = 1e-6 * this->LargestHeight; // Single precision.
  double least = 1.0;
  for (const double step : along.Steps)
  {
    least = step > digits ? std::min(least, step) : least;
  }
  return least;
}

//----------------------------------------------------------------------------------------------------------------------
HeightNoise NoiseSampler::Noise() const
{
  const double rounding = std::min(this->LeastStep(this->AlongX), this->LeastStep(this->AlongY)) / std::sqrt(12.0);
  const double noise = std::max(NoiseOf(this->AlongX.Second), NoiseOf(this->AlongY.Second));
  return { std::max(noise, rounding), noise <= rounding };
}
}
