// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleQuality.h"

#include "Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
TriangleQuality MeasureQuality(const std::vector<PlanePoint>& places, const RawVector<PointId>& triangles)
{
  TriangleQuality quality;
  quality.Compactness.reserve(triangles.size() / 3);
  quality.Shape.reserve(triangles.size() / 3);
  // The largest cotangent belongs to the smallest angle.
  double largestCotangent = -1.0;
  for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
  {
    const PlanePoint& a = places[std::size_t(triangles[corner])];
    const PlanePoint& b = places[std::size_t(triangles[corner + 1])];
    const PlanePoint& c = places[std::size_t(triangles[corner + 2])];
    const double area = 0.5 * double(SignedArea(a, b, c));
    std::array<double, 3> side = { std::hypot(double(a.X) - b.X, double(a.Y) - b.Y),
      std::hypot(double(b.X) - c.X, double(b.Y) - c.Y), std::hypot(double(c.X) - a.X, double(c.Y) - a.Y) };
    std::sort(side.begin(), side.end());
    const double squares = side[0] * side[0] + side[1] * side[1] + side[2] * side[2];
    quality.Compactness.push_back(4.0 * std::sqrt(3.0) * area / squares);
    quality.Shape.push_back(4.0 * std::sqrt(3.0) * area / (side[2] * (side[0] + side[1] + side[2])));
    // The law of cosines for the angle opposite to the shortest side.
    largestCotangent =
      std::max(largestCotangent, (side[1] * side[1] + side[2] * side[2] - side[0] * side[0]) / (4.0 * area));
  }
  if (!triangles.empty())
  {
    quality.SmallestAngle = std::atan2(1.0, largestCotangent) * 45.0 / std::atan(1.0);
  }
  return quality;
}
}
