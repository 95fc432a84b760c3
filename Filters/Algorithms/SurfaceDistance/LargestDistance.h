// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds the largest distance from one surface to another: a place has the lower bound, no place exceeds the upper.

#ifndef SeismicHorizonsLargestDistance_h
#define SeismicHorizonsLargestDistance_h

#include "Common/Base/Monitor.h"
#include "DistanceProbe.h"
#include "PlanOverlay.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct LargestDistance
{
  MetricValues Found = {}; // at a place
  MetricValues Most = {}; // of all places, up to rounding
};

struct KnownDistances
{
  const TriangleSurface& From;
  const TriangleSearch& To;
  const PlanOverlay* Overlay; // null unless the other surface is a height field
  const std::vector<Metric>& Metrics;
  /// Distances are by metric, then point.
  const std::vector<const std::vector<double>*>& Distance;
  const std::vector<NearestTriangles>& Nearest;
  MetricValues Found; // largest so far, and of corners that count
};

/// If bounds are more than 1 % apart, about `effort` distances are measured in addition.
LargestDistance FindLargestDistance(const KnownDistances& known, std::int64_t effort, const Monitor& monitor);
}

#endif
