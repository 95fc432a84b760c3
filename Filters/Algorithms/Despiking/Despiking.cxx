// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spurs are found first, by an opening along rows, then columns, in time linear in the places of the index, whatever
// the width. Then a plane of medians through the points around finds spikes.

#include "Despiking.h"

#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Median.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t PointsPerTask = 4096;
constexpr std::size_t FewestAround = 3;
constexpr double NoiseFactor = 4.0;

void CheckDespikingOptions(const DespikingOptions& options)
{
  CheckAtLeast("threshold", options.Threshold, 0.0, " lattice units");
  CheckWithin("neighborhood radius", options.Radius, 1, LargestMedianRadius, " columns");
  CheckWithin("spur width", options.SpurWidth, 0, LargestSpurWidth, " columns");
}

// ---- Spurs ----------------------------------------------------------------------------------------------------------

/// A mark stays if the next `length` places of the line, its own included, are marked.
void Erode(unsigned char* line, std::int64_t places, std::int64_t stride, int length)
{
  int run = 0;
  for (std::int64_t n = places; n-- > 0;)
  {
    unsigned char& mark = line[n * stride];
    run = mark != 0 ? run + 1 : 0;
    mark = run >= length ? 1 : 0;
  }
}

void Dilate(unsigned char* line, std::int64_t places, std::int64_t stride, int length)
{
  int left = 0;
  for (std::int64_t n = 0; n < places; ++n)
  {
    unsigned char& mark = line[n * stride];
    left = mark != 0 ? length : std::max(left - 1, 0);
    mark = left > 0 ? 1 : 0;
  }
}

std::vector<PointId> FindSpurs(const ColumnIndex& index, int width)
{
  std::vector<unsigned char> marks(index.NumberOfPlaces(), 0);
  index.ForEachPoint(0, index.NumberOfPlaces(), [&marks](std::int64_t place, PointId) { marks[place] = 1; });
  for (const auto filter : { Erode, Dilate })
  {
    for (std::int64_t y = 0; y < index.Height(); ++y)
    {
      filter(marks.data() + y * index.Width(), index.Width(), 1, width + 1);
    }
    for (std::int64_t x = 0; x < index.Width(); ++x)
    {
      filter(marks.data() + x, index.Height(), index.Width(), width + 1);
    }
  }
  std::vector<PointId> spurs;
  index.ForEachPoint(0, index.NumberOfPlaces(),
    [&](std::int64_t place, PointId point)
    {
      if (marks[place] == 0)
      {
        spurs.push_back(point);
      }
    });
  return spurs;
}

// ---- Spikes ---------------------------------------------------------------------------------------------------------

double Median(std::vector<double>& values)
{
  const double upper = UpperMedian(values);
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  return values.size() % 2 == 1 ? upper : 0.5 * (upper + *std::max_element(values.begin(), middle));
}

/// Values by place pay off, as each point looks at many places; places without a point are NaN.
std::vector<double> ListHeights(const ColumnIndex& index, const std::vector<double>& heights)
{
  std::vector<double> byPlace(index.NumberOfPlaces(), std::numeric_limits<double>::quiet_NaN());
  index.ForEachPoint(
    0, index.NumberOfPlaces(), [&](std::int64_t place, PointId point) { byPlace[place] = heights[point]; });
  return byPlace;
}

class Surroundings
{
public:
  Surroundings(const std::vector<double>& heights, std::int64_t width, int radius)
    : Heights(heights)
    , Width(width)
    , Radius(radius)
  {
  }

  /// Returns the height above the plane through the points around, NaN with too few of them.
  double Deviation(std::int64_t place)
  {
    const double alongX = this->Dip(place, 1, 0);
    const double alongY = this->Dip(place, 0, 1);
    this->Around.clear();
    for (std::int64_t y = -this->Radius; y <= this->Radius; ++y)
    {
      for (std::int64_t x = -this->Radius; x <= this->Radius; ++x)
      {
        const double height = this->Heights[place + y * this->Width + x];
        if (!std::isnan(height) && (x != 0 || y != 0))
        {
          this->Around.push_back(height - alongX * double(x) - alongY * double(y));
        }
      }
    }
    if (this->Around.size() < FewestAround)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    this->Level = Median(this->Around);
    return this->Heights[place] - this->Level;
  }

  /// Returns the median distance from the last plane or, as medians of integers leap, the mean if less.
  double Spread()
  {
    constexpr double medianPerMean = 0.845; // of normal noise
    double sum = 0.0;
    for (double& height : this->Around)
    {
      height = std::abs(height - this->Level);
      sum += height;
    }
    return std::min(Median(this->Around), medianPerMean * sum / double(this->Around.size()));
  }

private:
  /// Returns 0 without neighbours. The point itself, which may be a spike, is left out.
  double Dip(std::int64_t place, std::int64_t x, std::int64_t y)
  {
    const std::int64_t step = y * this->Width + x;
    this->Around.clear();
    for (std::int64_t row = -this->Radius; row <= this->Radius - y; ++row)
    {
      for (std::int64_t column = -this->Radius; column <= this->Radius - x; ++column)
      {
        const std::int64_t first = place + row * this->Width + column;
        const double difference = this->Heights[first + step] - this->Heights[first];
        if (!std::isnan(difference) && first != place && first + step != place)
        {
          this->Around.push_back(difference);
        }
      }
    }
    return this->Around.empty() ? 0.0 : Median(this->Around);
  }

  const std::vector<double>& Heights;
  const std::int64_t Width;
  const std::int64_t Radius;
  std::vector<double> Around;
  double Level = 0.0;
};

/// Returns the least step above `rounding`, at most 1: a surface that is level except at a fault has no smaller step
/// than its throw.
double LeastStep(const std::vector<double>& heights, std::int64_t width, double rounding)
{
  double least = 1.0;
  for (std::size_t place = std::size_t(width); place < heights.size(); ++place)
  {
    for (const std::size_t before : { place - 1, place - std::size_t(width) })
    {
      const double step = std::abs(heights[place] - heights[before]);
      least = step > rounding && step < least ? step : least;
    }
  }
  return least;
}

/// Clips large deviations, and includes the rounding of differences. Deviations may be NaN.
double NoiseOf(const std::vector<double>& byPlace, std::int64_t width, const std::vector<double>& deviations)
{
  constexpr double clip = 4.0; // medians
  constexpr double few = 0.1; // of the points, which may all be spikes
  const double rootOfSix = std::sqrt(6.0); // two roundings of variance 1 / 12
  constexpr double digits = 1e-6; // of single precision
  double largest = 0.0;
  for (const double height : byPlace)
  {
    largest = std::abs(height) > largest ? std::abs(height) : largest;
  }
  const double rounding = digits * largest;
  const double step = LeastStep(byPlace, width, rounding);
  const double least = std::max(rounding, step / rootOfSix);
  std::vector<double> sizes;
  sizes.reserve(deviations.size());
  for (const double deviation : deviations)
  {
    if (!std::isnan(deviation))
    {
      sizes.push_back(std::abs(deviation));
    }
  }
  if (sizes.empty())
  {
    return least;
  }
  const double count = double(sizes.size());
  double median = Median(sizes);
  if (median <= rounding)
  {
    sizes.erase(std::remove_if(sizes.begin(), sizes.end(), [&](double size) { return size <= rounding; }), sizes.end());
    if (double(sizes.size()) <= few * count)
    {
      return least;
    }
    median = Median(sizes);
  }
  double sum = 0.0;
  for (const double size : sizes)
  {
    sum += std::pow(std::min(size, clip * median), 2);
  }
  return std::max(least, std::sqrt(sum / count));
}
}

//----------------------------------------------------------------------------------------------------------------------
double MeasureNoise(PlanePoints columns, const std::vector<double>& heights)
{
  assert(heights.size() == columns.size());
  constexpr std::size_t enough = 100000;
  constexpr int radius = 2;
  if (columns.empty())
  {
    return 0.0;
  }
  const ColumnIndex index(columns, radius, radius);
  const PlanePoints near = index.Columns();
  const std::vector<double> byPlace = ListHeights(index, heights);
  Surroundings surroundings(byPlace, index.Width(), radius);
  std::vector<double> deviations;
  // The golden ratio varies the sampled place, as noise may repeat with the rows.
  constexpr double golden = 0.6180339887498949;
  const std::size_t step = columns.size() / enough + 1;
  double part = 0.0;
  for (std::size_t n = 0; n + step <= near.size(); n += step)
  {
    part = part + golden < 1.0 ? part + golden : part + golden - 1.0;
    deviations.push_back(surroundings.Deviation(index.Place(near[n + std::size_t(part * double(step))])));
  }
  return NoiseOf(byPlace, index.Width(), deviations);
}

//----------------------------------------------------------------------------------------------------------------------
Spikes FindSpikes(
  PlanePoints given, const std::vector<double>& heights, const DespikingOptions& options, const Monitor& monitor)
{
  assert(heights.size() == given.size());
  CheckDespikingOptions(options);
  const ColumnIndex index(given, options.Radius, options.Radius);
  const PlanePoints columns = index.Columns();
  Spikes spikes;
  spikes.Kind.assign(columns.size(), SpikeKind::None);
  if (options.SpurWidth > 0)
  {
    for (const PointId point : FindSpurs(index, options.SpurWidth))
    {
      spikes.Kind[point] = SpikeKind::Spur;
    }
  }
  const std::vector<double> byPlace = ListHeights(index, heights);
  std::vector<double> deviations(columns.size());
  ParallelFor(std::int64_t(columns.size()), PointsPerTask, monitor.Step(0.3, 0.9),
    [&](std::int64_t first, std::int64_t last)
    {
      Surroundings surroundings(byPlace, index.Width(), options.Radius);
      for (std::int64_t n = first; n < last; ++n)
      {
        deviations[n] = surroundings.Deviation(index.Place(columns[n]));
      }
    });
  const bool isGiven = options.Threshold > 0.0;
  spikes.Threshold = isGiven ? options.Threshold
    : columns.empty()        ? 0.0
                             : NoiseFactor * NoiseOf(byPlace, index.Width(), deviations);
  ParallelFor(std::int64_t(columns.size()), PointsPerTask, monitor.Step(0.9, 1.0),
    [&](std::int64_t first, std::int64_t last)
    {
      Surroundings surroundings(byPlace, index.Width(), options.Radius);
      for (std::int64_t n = first; n < last; ++n)
      {
        if (!(std::abs(deviations[n]) > spikes.Threshold)) // also false for NaN
        {
          continue;
        }
        if (!isGiven)
        {
          surroundings.Deviation(index.Place(columns[n]));
        }
        if (isGiven || std::abs(deviations[n]) > NoiseFactor * surroundings.Spread())
        {
          spikes.Kind[n] = SpikeKind::Spike;
        }
      }
    });
  return spikes;
}
}
