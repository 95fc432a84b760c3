// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A raster measures a place in steps, each only if needed:
//
// 1. The triangle above or below is kept as a Facet. If the ball that touches its plane is within the triangle in plan,
// and nothing overlaps it, it is nearest.
// 2. The distance to it, or to the last nearest triangle, is a bound.
// 3. The raster is searched within the bound.
//
// A tree is searched from the last nearest triangle.

#include "DistanceProbe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
// These are squares: the width of needles, and rounding at their ends, relative to their length.
constexpr double LeastWidth = 1e-12;
constexpr double RoundingAtEnds = 1e-17;
}

//----------------------------------------------------------------------------------------------------------------------
TriangleSearch::TriangleSearch(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
  , Raster(std::make_unique<TriangleRaster>(surface, monitor.Step(0.0, 0.5)))
{
  if (!this->Raster->IsWorthwhile())
  {
    this->Raster.reset();
    this->Tree = std::make_unique<TriangleTree>(surface, monitor.Step(0.5, 1.0));
  }
}

// ---- Facet ----------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
void Facet::Set(const TriangleRaster& raster, std::int32_t number, const std::vector<Metric>& metrics)
{
  const TriangleSurface& surface = raster.GetSurface();
  const Corners& t = surface.Triangles[number];
  this->Number = number;
  this->IsAlone = raster.IsAlone(number);
  this->Slack = raster.Slack();
  this->Corner = { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) };
  const Eigen::Vector3d sides[3] = { this->Corner[2] - this->Corner[1], this->Corner[0] - this->Corner[2],
    this->Corner[1] - this->Corner[0] };
  this->Turn = sides[0].x() * sides[1].y() - sides[0].y() * sides[1].x() < 0.0 ? -1.0 : 1.0;
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    this->SetPlane(metrics[metric], sides, this->Planes[metric]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void Facet::SetPlane(const Metric& metric, const Eigen::Vector3d (&sides)[3], Plane& plane) const
{
  const Eigen::Vector3d mapped[3] = { metric(sides[0]), metric(sides[1]), metric(sides[2]) };
  const Eigen::Vector3d normal = mapped[0].cross(mapped[1]);
  const double longest = std::max(std::max(mapped[0].squaredNorm(), mapped[1].squaredNorm()), mapped[2].squaredNorm());
  plane.Normal = metric.Transposed(normal);
  plane.SquaredNormal = normal.squaredNorm();
  for (std::size_t side = 0; side < 3; ++side)
  {
    plane.SquaredSides[side] = mapped[side].head<2>().squaredNorm();
  }
  plane.Shrinkage = metric.SquaredPlanShrinkage();
  plane.SquaredSlack = MuchMore * this->Slack * this->Slack * metric.SquaredPlanNorm();
  plane.IsWide = plane.SquaredNormal > SquaredWidthOfNeedle * longest * longest;
  // Rounding tilts the plane of a needle; at its ends, the error must be less than the slack.
  const bool isRightAtEnds =
    plane.SquaredNormal > LeastWidth * longest * longest && RoundingAtEnds * longest <= plane.SquaredSlack;
  plane.IsSure = this->IsAlone && (plane.IsWide || isRightAtEnds);
}

//----------------------------------------------------------------------------------------------------------------------
double Facet::Height() const
{
  return (this->Areas[0] * this->Corner[0].z() + this->Areas[1] * this->Corner[1].z() +
           this->Areas[2] * this->Corner[2].z()) /
    (this->Areas[0] + this->Areas[1] + this->Areas[2]);
}

//----------------------------------------------------------------------------------------------------------------------
bool Facet::IsOnlyOne(double distance) const
{
  const double squared = (distance + this->Slack) * (distance + this->Slack);
  const auto isFar = [&](std::size_t n)
  {
    const auto side = (this->Corner[(n + 1) % 3] - this->Corner[(n + 2) % 3]).head<2>();
    return this->Areas[n] * this->Areas[n] > squared * side.squaredNorm();
  };
  return this->IsAlone && isFar(0) && isFar(1) && isFar(2);
}

// ---- Probe ----------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
DistanceProbe::DistanceProbe(const TriangleSearch& to, const std::vector<Metric>& metrics)
  : To(to)
  , Metrics(metrics)
  , NumberOfMetrics(metrics.size())
{
  assert(metrics.size() >= 1 && metrics.size() <= MostMetrics);
}

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
    this->Across.Set(raster, across, this->Metrics);
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
    squared = this->Metrics[metric].SquaredDistance(surface, surface.Triangles[nearest], place);
  }
  if (!isFound)
  {
    raster.Search(place, this->Metrics[metric], nearest, squared);
  }
  return squared;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename IsWanted>
void DistanceProbe::Measure(const Eigen::Vector3d& place, IsWanted&& isWanted)
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

//----------------------------------------------------------------------------------------------------------------------
const MetricValues& DistanceProbe::operator()(const Eigen::Vector3d& place)
{
  this->Measure(place, [](std::size_t) { return true; });
  return this->Found;
}

//----------------------------------------------------------------------------------------------------------------------
void DistanceProbe::RaiseLargest(const Eigen::Vector3d& place)
{
  // The nearest place is no farther than the place above or below.
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
