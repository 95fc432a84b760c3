// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of the points, the edges and the outline of a surface.

#ifndef SeismicHorizonsPlaceMeters_h
#define SeismicHorizonsPlaceMeters_h

#include "Common/Monitor.h"
#include "MeasuredSurface.h"
#include "SurfaceDistance.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Writes the distances of all points, by metric, and gives the largest of those that are corners of triangles and
/// count. With a tolerance above 0, writes how far points are above the other surface as well, to the first one
/// (FindHeight).
MetricValues MeasurePoints(const TriangleSurface& from, const TriangleSearch& to, const std::vector<Metric>& metrics,
  double tolerance, std::vector<PointDistances>& points, const Monitor& monitor);

/// The largest distance of samples on edges, one for each `spacing` of their length, and of the points, which
/// MeasurePoints gives. Shorter edges have no samples: their ends are measured as points. Lengths are those of the
/// first metric.
MetricValues MeasureEdges(const TriangleSurface& from, const SurfaceEdges& edges, const TriangleSearch& to,
  const std::vector<Metric>& metrics, const std::vector<PointDistances>& points, const MetricValues& ofPoints,
  double spacing, std::uint64_t seed, const Monitor& monitor);

/// The largest distance of one outline to the other; nan when one of them is empty.
MetricValues MeasureOutline(const MeasuredSurface& from, const MeasuredSurface& to, double spacing, std::uint64_t seed);
}

#endif
