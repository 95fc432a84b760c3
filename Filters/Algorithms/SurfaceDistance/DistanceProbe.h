// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of places to a surface, in all metrics at one visit.

#ifndef SeismicHorizonsDistanceProbe_h
#define SeismicHorizonsDistanceProbe_h

#include "Facet.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace SeismicHorizons
{
using MetricValues = std::array<double, MostMetrics>; // by metric

/// Each search begins with what the one before found, so that a probe serves one chunk: with the same places in the
/// same order it finds the same triangles.
class DistanceProbe
{
public:
  /// There are one or two metrics.
  DistanceProbe(const TriangleSearch& to, const std::vector<Metric>& metrics)
    : To(to)
    , Metrics(metrics)
    , NumberOfMetrics(metrics.size())
  {
  }

  const MetricValues& operator()(const Eigen::Vector3d& place);

  /// The same where only the largest distance is asked for: places that are surely nearer are not measured.
  void RaiseLargest(const Eigen::Vector3d& place);

  /// The height of the surface at the place that was measured last, as that of TriangleTree.
  double FindHeight(const Eigen::Vector3d& place, double tolerance) const;

  /// Of all places so far, and of those that are known to be as far.
  const MetricValues& Largest() const { return this->Farthest; }
  void SetLargest(const MetricValues& largest) { this->Farthest = largest; }

private:
  /// Measures a place in those metrics for which isWanted(metric) is true.
  template <typename IsWanted>
  void Measure(const Eigen::Vector3d& place, IsWanted&& isWanted)
  {
    const TriangleRaster* const raster = this->To.GetRaster();
    const std::int32_t across = raster != nullptr ? this->FindAcross(*raster, place) : -1;
    for (std::size_t metric = 0; metric < this->NumberOfMetrics; ++metric)
    {
      if (isWanted(metric))
      {
        const double squared = raster != nullptr
          ? this->MeasureByRaster(*raster, place, across, metric)
          : this->To.GetTree().SquaredDistance(place, this->Nearest[metric], this->Metrics[metric]);
        this->Found[metric] = std::sqrt(squared);
        this->Farthest[metric] = std::max(this->Farthest[metric], this->Found[metric]);
      }
    }
  }

  std::int32_t FindAcross(const TriangleRaster& raster, const Eigen::Vector3d& place);
  double MeasureByRaster(
    const TriangleRaster& raster, const Eigen::Vector3d& place, std::int32_t across, std::size_t metric);

  const TriangleSearch& To;
  const std::vector<Metric>& Metrics;
  std::size_t NumberOfMetrics;
  Facet Across; // the last one above or below a place
  bool IsAcross = false; // whether it is above or below the last place
  std::array<std::int32_t, MostMetrics> Nearest = {};
  MetricValues Found = {};
  MetricValues Farthest = {};
};
}

#endif
