// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A surface with what it takes to measure from it and to it.

#ifndef SeismicHorizonsMeasuredSurface_h
#define SeismicHorizonsMeasuredSurface_h

#include "DistanceProbe.h"
#include "SurfaceEdges.h"
#include "TriangleSearch.h"

#include <vector>

namespace SeismicHorizons
{
struct MeasuredSurface
{
  const TriangleSurface& Surface;
  const std::vector<Metric>& Metrics;
  TriangleSearch Search;
  SurfaceEdges Edges;
  TriangleSurface Outline;
  MetricValues Area = {}; // of what counts

  MeasuredSurface(const TriangleSurface& surface, const std::vector<Metric>& metrics, const Monitor& monitor);
};
}

#endif
