// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contours of a surface of triangles, joined into long lines.

#ifndef SeismicHorizonsContours_h
#define SeismicHorizonsContours_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
using PlanTriangles = std::vector<std::array<PointId, 3>>;

/// Where a contour crosses an edge.
struct ContourPoint
{
  Edge Crossed; // The lesser point is the first, so that neighbouring triangles have the same place.
  double Fraction = 0.0; // from the first point to the second
};

/// A closed contour ends with its first point. The higher side is to the left, seen from above.
struct Contour
{
  std::int64_t Level = 0; // intervals
  std::vector<ContourPoint> Points;
};

/// Triangles between neighbouring columns with a point: two where four columns have one, one where three have. A square
/// with a faulted link stays open. `cuts` may be null.
PlanTriangles JoinColumns(PlanePoints columns, const std::vector<double>& heights, const LinkCuts* cuts);

/// Triangles are counter-clockwise, seen from above. A point at a level counts as above it. Contours are sorted by level.
/// Throws InputError if there are more than 10,000 levels.
std::vector<Contour> FindContours(const PlanTriangles& triangles, const std::vector<double>& heights, double interval,
  const Monitor& monitor = Monitor());
}

#endif
