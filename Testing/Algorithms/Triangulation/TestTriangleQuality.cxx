// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Filters/Algorithms/Triangulation/TriangleQuality.h"
#include "Tools/Check.h"

#include <cmath>

using namespace SeismicHorizons;

namespace
{
bool IsNear(double a, double b)
{
  return std::abs(a - b) < 1e-6;
}
}

int TestTriangleQuality(int, char*[])
{
  // Nearly equilateral, and half a square.
  const std::vector<PlanePoint> places = { { 0, 0 }, { 2000000, 0 }, { 1000000, 1732051 }, { 0, 1000000 },
    { 1000000, 0 } };
  TriangleQuality quality = MeasureQuality(places, { 0, 1, 2 });
  CHECK(IsNear(quality.Compactness[0], 1.0));
  CHECK(IsNear(quality.Shape[0], 1.0));
  CHECK(IsNear(quality.SmallestAngle, 60.0) || std::abs(quality.SmallestAngle - 60.0) < 1e-4);

  // Sides 1, 1 and the square root of 2, area 1/2.
  quality = MeasureQuality(places, { 0, 1, 2, 0, 4, 3 });
  CHECK_EQUAL(quality.Compactness.size(), 2u);
  CHECK(IsNear(quality.Compactness[1], 4.0 * std::sqrt(3.0) * 0.5 / 4.0));
  CHECK(IsNear(quality.Shape[1], 2.0 * std::sqrt(3.0) * 0.5 / (std::sqrt(2.0) * (1.0 + std::sqrt(0.5)))));
  CHECK(IsNear(quality.SmallestAngle, 45.0));

  CHECK_EQUAL(MeasureQuality(places, {}).SmallestAngle, 180.0);
  return Check::Result();
}
