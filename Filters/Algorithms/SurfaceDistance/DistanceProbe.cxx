// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceProbe.h"

#include <cmath>
#include <limits>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::int32_t DistanceProbe::FindAcross(const TriangleRaster& raster, const Eigen::Vector3d& place)
{
  this->IsAcross = this->Across.Contains(place);
  if (this->IsAcross)
  {
    return this->Across.GetNumber();
  }
  const std::int32_t across = raster.FindAcross(place);
  if (across >= 0 && across != this->Across.GetNumber())
  {
    this->Across.Set(raster.GetSurface(), across, raster.IsAlone(across), raster.Slack(), this->Metrics);
    this->IsAcross = this->Across.Contains(place);
  }
  return across;
}

//----------------------------------------------------------------------------------------------------------------------
double DistanceProbe::MeasureByRaster(
  const TriangleRaster& raster, const Eigen::Vector3d& place, std::int32_t across, std::size_t metric)
{
  std::int32_t& nearest = this->Nearest[metric];
  nearest = across >= 0 ? across : nearest;
  double squared = 0.0;
  const bool isFound = this->IsAcross && this->Across.IsNearest(metric, place, squared);
  if (!isFound || !this->Across.IsWide(metric))
  {
    const TriangleSurface& surface = raster.GetSurface();
    squared = this->Metrics[metric].SquaredDistance(surface, surface.Triangles[std::size_t(nearest)], place);
  }
  if (!isFound)
  {
    raster.Search(place, this->Metrics[metric], nearest, squared);
  }
  return squared;
}

//----------------------------------------------------------------------------------------------------------------------
const MetricValues& DistanceProbe::operator()(const Eigen::Vector3d& place)
{
  this->Measure(place, [](std::size_t) { return true; });
  return this->Found;
}

//----------------------------------------------------------------------------------------------------------------------
void DistanceProbe::RaiseLargest(const Eigen::Vector3d& place)
{
  // The place right above or below is as far away as the nearest one, or farther.
  double gap = std::numeric_limits<double>::quiet_NaN();
  this->Measure(place,
    [&](std::size_t metric)
    {
      gap = this->IsAcross && std::isnan(gap) ? std::abs(this->Across.Height() - place.z()) : gap;
      return !(gap * this->Metrics[metric].Weights()[2] <= this->Farthest[metric]);
    });
}

//----------------------------------------------------------------------------------------------------------------------
double DistanceProbe::FindHeight(const Eigen::Vector3d& place, double tolerance) const
{
  const TriangleRaster* const raster = this->To.GetRaster();
  if (raster == nullptr)
  {
    return this->To.GetTree().FindHeight(place, tolerance);
  }
  return this->IsAcross && this->Across.IsOnlyOne(2.0 * tolerance) ? this->Across.Height()
                                                                   : raster->FindHeight(place, tolerance);
}
}
