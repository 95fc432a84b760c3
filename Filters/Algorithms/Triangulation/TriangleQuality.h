// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How near triangles are to equilateral ones, in plan.

#ifndef SeismicHorizonsTriangleQuality_h
#define SeismicHorizonsTriangleQuality_h

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct TriangleQuality
{
  /// For each triangle 4 sqrt(3) area / (sum of squared sides) (Gueziec; thesis eq. 5.9): 1 when it is equilateral,
  /// towards 0 the thinner it is.
  RawVector<float> Compactness;
  /// For each triangle 2 sqrt(3) area / (longest side x half the perimeter) (Frey and Borouchaki; thesis eq. 5.10): the
  /// same range.
  RawVector<float> Shape;
  /// The smallest angle of all triangles, in degrees; 180 without triangles.
  double SmallestAngle = 180.0;
};

/// `triangles` has three points per triangle, counter-clockwise.
TriangleQuality MeasureQuality(const std::vector<PlanePoint>& places, const RawVector<PointId>& triangles);
}

#endif
