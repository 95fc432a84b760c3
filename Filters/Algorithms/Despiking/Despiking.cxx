// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Despiking.h"

#include "Boundary/ColumnRaster.h"
#include "Boundary/EmptyBands.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "Opening.h"

#include <algorithm>
#include <cmath>

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

/// The median of numbers, whose order changes; of an even number of them the mean of the two in the middle.
double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

bool IsSpike(const ColumnRaster& raster, const std::vector<double>& heights, std::int64_t place,
  const DespikingOptions& options, std::vector<double>& around)
{
  around.clear();
  for (std::int64_t y = -options.Radius; y <= options.Radius; ++y)
  {
    for (std::int64_t x = -options.Radius; x <= options.Radius; ++x)
    {
      const PointId point = raster[place + y * raster.Width() + x];
      if (point != NoPoint && (x != 0 || y != 0))
      {
        around.push_back(heights[std::size_t(point)]);
      }
    }
  }
  return around.size() >= FewestAround &&
    std::abs(heights[std::size_t(raster[place])] - Median(around)) > options.Threshold;
}

std::vector<SpikeKind> Find(const std::vector<PlanePoint>& columns, const std::vector<double>& heights,
  const DespikingOptions& options, const Monitor& monitor)
{
  const ColumnRaster raster(columns, std::max(options.Radius, 1));
  std::vector<SpikeKind> kinds(columns.size(), SpikeKind::None);
  if (options.ThreadWidth > 0)
  {
    for (const PointId point : FindThreads(raster, options.ThreadWidth))
    {
      kinds[std::size_t(point)] = SpikeKind::Thread;
    }
  }
  ParallelFor(std::int64_t(columns.size()), Grain, monitor.Step(0.3, 1.0),
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<double> around;
      for (std::int64_t n = first; n < last; ++n)
      {
        const std::size_t point = std::size_t(n);
        if (IsSpike(raster, heights, raster.Place(columns[point]), options, around))
        {
          kinds[point] = SpikeKind::Spike;
        }
      }
    });
  return kinds;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<SpikeKind> FindSpikes(const std::vector<PlanePoint>& columns, const std::vector<double>& heights,
  const DespikingOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  return WithoutWideBands(columns, options.Radius,
    [&](const std::vector<PlanePoint>& near) { return Find(near, heights, options, monitor); });
}
}
