// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleQuality.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct Shape
{
  Shape(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
    : Side{ Distance(a, b), Distance(b, c), Distance(c, a) }
    , Area(0.5 * double(SignedArea(a, b, c)))
  {
    std::sort(this->Side.begin(), this->Side.end());
  }

  static double Distance(const PlanePoint& a, const PlanePoint& b) { return std::sqrt(double(SquaredDistance(a, b))); }

  double Squared(std::size_t n) const { return this->Side[n] * this->Side[n]; }

  double Compactness() const
  {
    return 4.0 * std::sqrt(3.0) * this->Area / (this->Squared(0) + this->Squared(1) + this->Squared(2));
  }

  double Quality() const
  {
    return 4.0 * std::sqrt(3.0) * this->Area / (this->Side[2] * (this->Side[0] + this->Side[1] + this->Side[2]));
  }

  double LargestCotangent() const
  {
    return (this->Squared(1) + this->Squared(2) - this->Squared(0)) / (4.0 * this->Area);
  }

  std::array<double, 3> Side;
  double Area;
};
}

//----------------------------------------------------------------------------------------------------------------------
void FaceUp(const Lattice& lattice, RawVector<PointId>& triangles)
{
  assert(triangles.size() % 3 == 0);
  for (std::size_t corner = 0; !lattice.KeepsOrientation() && corner < triangles.size(); corner += 3)
  {
    std::swap(triangles[corner + 1], triangles[corner + 2]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
TriangleQuality MeasureQuality(const std::vector<PlanePoint>& places, const RawVector<PointId>& triangles)
{
  TriangleQuality quality;
  assert(triangles.size() % 3 == 0);
  quality.Compactness.resize(triangles.size() / 3);
  quality.Shape.resize(triangles.size() / 3);
  const auto at = [&](std::int64_t corner) { return places[triangles[corner]]; };
  // The largest cotangent belongs to the smallest angle.
  double largest = -1.0;
  std::mutex mutex;
  ParallelFor(std::int64_t(triangles.size() / 3), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      double largestHere = -1.0;
      for (std::int64_t triangle = first; triangle < last; ++triangle)
      {
        const Shape shape(at(3 * triangle), at(3 * triangle + 1), at(3 * triangle + 2));
        quality.Compactness[triangle] = float(shape.Compactness());
        quality.Shape[triangle] = float(shape.Quality());
        largestHere = std::max(largestHere, shape.LargestCotangent());
      }
      const std::lock_guard<std::mutex> lock(mutex);
      largest = std::max(largest, largestHere);
    });
  if (!triangles.empty())
  {
    quality.SmallestAngle = std::atan2(1.0, largest) * 45.0 / std::atan(1.0);
  }
  return quality;
}
}
