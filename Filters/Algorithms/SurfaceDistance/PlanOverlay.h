// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a triangle is at most from a surface that covers it in plan.
//
// Each place of the triangle is above or below a triangle of the surface. Over the part that the two have in common in
// plan, a convex polygon, the distance to the one of the surface is a convex function: it is largest at a corner of the
// polygon. The vertical gap between their planes is longer, and takes less time: it is linear, and largest at corners
// of either of the two triangles, also where these are outside the polygon.
//
// What is covered is known without adding up areas: the plan of a surface ends at sides that have no triangle on one of
// their sides. Where none of these passes through a triangle, and the surface has anything there, it covers all of it.

#ifndef SeismicHorizonsPlanOverlay_h
#define SeismicHorizonsPlanOverlay_h

#include "Metric.h"
#include "TriangleRaster.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
using Triangle = std::array<Eigen::Vector3d, 3>;

class PlanOverlay
{
public:
  /// Linear, on several threads; 1 byte per triangle, and 9 per point while it is made. The raster must outlive it.
  explicit PlanOverlay(const TriangleRaster& raster);

  /// Lowers `bounds` to how far any place of a triangle is from the surface at most, by metric. Bounds that are not
  /// above `enough` stay as they are; those that it leaves may be above the largest distance, if not by more than
  /// rounding where that is at a corner of the two surfaces' overlay. Returns how many triangles it looked at.
  std::int64_t Lower(const Triangle& corners, const std::vector<Metric>& metrics, const MetricValues& enough,
    MetricValues& bounds) const;

private:
  class Measure;

  const TriangleRaster& Raster;
  std::vector<unsigned char> Ends; // by triangle: a bit for each side where the surface may end
};
}

#endif
