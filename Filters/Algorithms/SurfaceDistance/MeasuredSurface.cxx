// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeasuredSurface.h"

#include "Common/FixedChunks.h"

#include <cstdint>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerChunk = 16384;

/// The area of what counts of a surface, by metric.
struct AreaSums
{
  MetricValues Area = {};

  void Add(const AreaSums& other)
  {
    for (std::size_t metric = 0; metric < MostMetrics; ++metric)
    {
      this->Area[metric] += other.Area[metric];
    }
  }
};

MetricValues MeasureAreas(const TriangleSurface& surface, const std::vector<Metric>& metrics)
{
  const auto addUp = [&](AreaSums& sums, std::int64_t first, std::int64_t last)
  {
    for (std::int64_t n = first; n < last; ++n)
    {
      const Corners& corners = surface.Triangles[std::size_t(n)];
      for (std::size_t metric = 0; metric < metrics.size() && surface.Counts(corners); ++metric)
      {
        sums.Area[metric] += metrics[metric].Area(surface, corners);
      }
    }
  };
  return AddUpChunks<AreaSums>(std::int64_t(surface.Triangles.size()), TrianglesPerChunk, Monitor(), addUp).Area;
}
}

//----------------------------------------------------------------------------------------------------------------------
MeasuredSurface::MeasuredSurface(
  const TriangleSurface& surface, const std::vector<Metric>& metrics, const Monitor& monitor)
  : Surface(surface)
  , Metrics(metrics)
  , Search(surface, monitor.Step(0.0, 0.7))
  , Edges(surface)
{
  monitor.Progress(0.8);
  this->Outline = FindOutline(surface, this->Edges);
  monitor.Progress(0.9);
  this->Area = MeasureAreas(surface, metrics);
}
}
