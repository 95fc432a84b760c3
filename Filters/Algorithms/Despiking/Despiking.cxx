// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps: find threads by a morphological opening, with a square one column wider than they may be; then spikes, each by
// the median of the points around it.
//
// Opening: a square is full when each of its rows is. So rows are looked at first, and then columns of what they gave;
// and the same the other way round to cover with squares. Takes time linear in the places of the index, whatever the
// width is.

#include "Despiking.h"

#include "Common/ColumnIndex.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 4096; // points that a thread takes at a time
constexpr std::size_t FewestAround = 3;

void CheckOptions(const DespikingOptions& options)
{
  CheckAtLeast("threshold", options.Threshold, 0.0, " lattice units");
  CheckWithin("neighborhood radius", options.Radius, 1, LargestMedianRadius, " columns");
  CheckWithin("thread width", options.ThreadWidth, 0, LargestThreadWidth, " columns");
}

//----------------------------------------------------------------------------------------------------------------------
// Threads

using Marks = std::vector<unsigned char>;

/// The lines of places of a index along one axis.
class LineFilter
{
public:
  LineFilter(std::int64_t lines, std::int64_t lineStride, std::int64_t places, std::int64_t placeStride)
    : Lines(lines)
    , LineStride(lineStride)
    , Places(places)
    , PlaceStride(placeStride)
  {
  }

  /// Leaves marks where the next `length` places of the line, the place included, are marked.
  void Erode(Marks& marks, int length) const
  {
    this->ForEachLine(
      [&](std::int64_t begin)
      {
        int run = 0;
        for (std::int64_t n = this->Places; n-- > 0;)
        {
          unsigned char& mark = marks[begin + n * this->PlaceStride];
          run = mark != 0 ? run + 1 : 0;
          mark = run >= length ? 1 : 0;
        }
      });
  }

  /// Marks the next `length` places of each mark.
  void Dilate(Marks& marks, int length) const
  {
    this->ForEachLine(
      [&](std::int64_t begin)
      {
        int left = 0;
        for (std::int64_t n = 0; n < this->Places; ++n)
        {
          unsigned char& mark = marks[begin + n * this->PlaceStride];
          left = mark != 0 ? length : std::max(left - 1, 0);
          mark = left > 0 ? 1 : 0;
        }
      });
  }

private:
  template <typename Work>
  void ForEachLine(Work&& work) const
  {
    for (std::int64_t line = 0; line < this->Lines; ++line)
    {
      work(line * this->LineStride);
    }
  }

  std::int64_t Lines;
  std::int64_t LineStride;
  std::int64_t Places;
  std::int64_t PlaceStride;
};

/// The points that no full square of width + 1 columns along each side covers.
std::vector<PointId> FindThreads(const ColumnIndex& index, int width)
{
  Marks marks(index.NumberOfPlaces(), 0);
  index.ForEachPoint(0, index.NumberOfPlaces(), [&marks](std::int64_t place, PointId) { marks[place] = 1; });
  const LineFilter alongRows(index.Height(), index.Width(), index.Width(), 1);
  const LineFilter alongColumns(index.Width(), 1, index.Height(), index.Width());
  alongRows.Erode(marks, width + 1);
  alongColumns.Erode(marks, width + 1);
  alongRows.Dilate(marks, width + 1);
  alongColumns.Dilate(marks, width + 1);
  std::vector<PointId> threads;
  index.ForEachPoint(0, index.NumberOfPlaces(),
    [&](std::int64_t place, PointId point)
    {
      if (marks[place] == 0)
      {
        threads.push_back(point);
      }
    });
  return threads;
}

//----------------------------------------------------------------------------------------------------------------------
// Spikes

/// The median of numbers, whose order changes; of an even number of them the mean of the two in the middle.
double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Heights by place, nan where there is no point: the search looks at many places for each point.
std::vector<double> ListHeights(const ColumnIndex& index, const std::vector<double>& heights)
{
  std::vector<double> byPlace(index.NumberOfPlaces(), std::numeric_limits<double>::quiet_NaN());
  index.ForEachPoint(
    0, index.NumberOfPlaces(), [&](std::int64_t place, PointId point) { byPlace[place] = heights[point]; });
  return byPlace;
}

bool IsSpike(const std::vector<double>& heights, std::int64_t width, std::int64_t place,
  const DespikingOptions& options, std::vector<double>& around)
{
  around.clear();
  for (std::int64_t y = -options.Radius; y <= options.Radius; ++y)
  {
    for (std::int64_t x = -options.Radius; x <= options.Radius; ++x)
    {
      const double height = heights[place + y * width + x];
      if (!std::isnan(height) && (x != 0 || y != 0))
      {
        around.push_back(height);
      }
    }
  }
  return around.size() >= FewestAround && std::abs(heights[place] - Median(around)) > options.Threshold;
}

std::vector<SpikeKind> Find(
  const ColumnIndex& index, const std::vector<double>& heights, const DespikingOptions& options, const Monitor& monitor)
{
  const PlanePoints columns = index.Columns();
  assert(heights.size() == columns.size());
  std::vector<SpikeKind> kinds(columns.size(), SpikeKind::None);
  if (options.ThreadWidth > 0)
  {
    for (const PointId point : FindThreads(index, options.ThreadWidth))
    {
      kinds[point] = SpikeKind::Thread;
    }
  }
  const std::vector<double> byPlace = ListHeights(index, heights);
  ParallelFor(std::int64_t(columns.size()), Grain, monitor.Step(0.3, 1.0),
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<double> around;
      for (std::int64_t n = first; n < last; ++n)
      {
        if (IsSpike(byPlace, index.Width(), index.Place(columns[n]), options, around))
        {
          kinds[n] = SpikeKind::Spike;
        }
      }
    });
  return kinds;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<SpikeKind> FindSpikes(
  PlanePoints columns, const std::vector<double>& heights, const DespikingOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  // Neighbours are in it.
  return Find(ColumnIndex(columns, options.Radius, options.Radius), heights, options, monitor);
}
}
