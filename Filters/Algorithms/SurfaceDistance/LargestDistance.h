// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The largest distance of one surface to another, within bounds: one that a place has, and one that no place exceeds.

#ifndef SeismicHorizonsLargestDistance_h
#define SeismicHorizonsLargestDistance_h

#include "Common/Monitor.h"
#include "DistanceProbe.h"
#include "PlanOverlay.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// By metric.
struct LargestDistance
{
  MetricValues Found = {}; // at a place
  MetricValues Most = {}; // of all places, up to rounding
};

/// What is known of the distances from a surface to another one.
struct KnownDistances
{
  const TriangleSurface& From;
  const TriangleSearch& To;
  const PlanOverlay* Overlay; // of the other surface; null where it is no height field
  const std::vector<Metric>& Metrics;
  /// By metric and point of From: the distance.
  const std::vector<const std::vector<double>*>& Distance;
  /// By point: the triangles of To that are nearest.
  const std::vector<NearestTriangles>& Nearest;
  MetricValues Found; // the largest distance of any place so far, and of all corners that count
};

/// Bounds of the largest distance of the triangles that count, and of their edges. `effort` is about how many distances
/// are measured beyond those known where the bounds would else be farther apart than 1 %. The same for any number of
/// threads.
LargestDistance FindLargestDistance(const KnownDistances& known, std::int64_t effort, const Monitor& monitor);
}

#endif
