// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds the largest distance from one surface to another: a place has the lower bound, no place exceeds the upper.

#ifndef SeismicHorizonsLargestDistance_h
#define SeismicHorizonsLargestDistance_h

#include "Common/Base/Monitor.h"
#include "DistanceProbe.h"
#include "SurfaceDistance.h"
#include "TriangleRaster.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
// Bounds the distance of a triangle from a surface that covers it in plan.
//
// Over the convex polygon shared with a triangle of the surface, the distance is convex, and largest at a corner. The
// gap between planes is longer but faster: linear, and largest at corners of either triangle.
//
// The surface covers a triangle if it has anything there, and its plan ends at no edge that passes through.

using Triangle = std::array<Eigen::Vector3d, 3>;

class PlanOverlay
{
public:
  /// Takes linear time, 1 byte per triangle, and temporarily 9 per point. The raster must outlive it.
  explicit PlanOverlay(const TriangleRaster& raster);

  /// Lowers bounds above `enough`, exactly only if the largest distance is at a corner of the overlay. Returns the
  /// number of triangles visited.
  std::int64_t Lower(const Triangle& corners, const std::vector<Metric>& metrics, const MetricValues& enough,
    MetricValues& bounds) const;

private:
  class Measure;

  const TriangleRaster& Raster;
  std::vector<unsigned char> Ends; // by triangle: a bit per edge where the surface may end
};

struct LargestDistance
{
  MetricValues Found = {}; // at a place
  MetricValues Most = {}; // of all places, up to rounding

  void Add(const LargestDistance& other)
  {
    KeepLarger(other.Found, this->Found);
    KeepLarger(other.Most, this->Most);
  }
};

struct KnownDistances
{
  const TriangleSurface& From;
  const TriangleSearch& To;
  const PlanOverlay* Overlay; // null unless the other surface is a height field
  const std::vector<Metric>& Metrics;
  const std::vector<PointDistances>& Points; // by metric
  const std::vector<NearestTriangles>& Nearest;
  MetricValues Found; // largest so far, and of corners that count
};

/// If bounds are more than 1 % apart, about `effort` distances are measured in addition.
LargestDistance FindLargestDistance(const KnownDistances& known, std::int64_t effort, const Monitor& monitor);
}

#endif
