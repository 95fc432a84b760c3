// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coordinates are below 2^29 (PlanePoint), so that squared lengths fit 64 bits and are exact.

#ifndef SeismicHorizonsPlaneGeometry_h
#define SeismicHorizonsPlaneGeometry_h

#include "Types.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace SeismicHorizons
{
inline std::int64_t SquaredLength(const PlanePoint& vector)
{
  return std::int64_t(vector.X) * vector.X + std::int64_t(vector.Y) * vector.Y;
}

inline std::int64_t SquaredDistance(const PlanePoint& a, const PlanePoint& b)
{
  const std::int64_t x = std::int64_t(b.X) - a.X;
  const std::int64_t y = std::int64_t(b.Y) - a.Y;
  return x * x + y * y;
}

/// Calls visit(column, part) for the columns strictly between two columns on a straight line; part is the fraction of
/// the way.
template <typename Visit>
void ForEachColumnBetween(const PlanePoint& from, const PlanePoint& to, Visit&& visit)
{
  const std::int32_t steps = std::gcd(to.X - from.X, to.Y - from.Y);
  for (std::int32_t step = 1; step < steps; ++step)
  {
    visit(PlanePoint{ from.X + (to.X - from.X) / steps * step, from.Y + (to.Y - from.Y) / steps * step },
      double(step) / steps);
  }
}

inline std::int64_t ScalarProduct(const PlanePoint& origin, const PlanePoint& a, const PlanePoint& b)
{
  const std::int64_t ax = std::int64_t(a.X) - origin.X;
  const std::int64_t ay = std::int64_t(a.Y) - origin.Y;
  const std::int64_t bx = std::int64_t(b.X) - origin.X;
  const std::int64_t by = std::int64_t(b.Y) - origin.Y;
  return ax * bx + ay * by;
}

/// An empty box has its least coordinates above its greatest.
struct PlaneBox
{
  PlaneBox() = default;

  explicit PlaneBox(PlanePoints places)
  {
    for (const PlanePoint& place : places)
    {
      this->Add(place);
    }
  }

  bool IsEmpty() const { return this->Least.X > this->Greatest.X; }

  bool Contains(const PlanePoint& place) const
  {
    return place.X >= this->Least.X && place.X <= this->Greatest.X && place.Y >= this->Least.Y &&
      place.Y <= this->Greatest.Y;
  }

  void Add(const PlanePoint& place)
  {
    this->Least = { std::min(this->Least.X, place.X), std::min(this->Least.Y, place.Y) };
    this->Greatest = { std::max(this->Greatest.X, place.X), std::max(this->Greatest.Y, place.Y) };
  }

  void Add(const PlaneBox& box)
  {
    this->Least = { std::min(this->Least.X, box.Least.X), std::min(this->Least.Y, box.Least.Y) };
    this->Greatest = { std::max(this->Greatest.X, box.Greatest.X), std::max(this->Greatest.Y, box.Greatest.Y) };
  }

  PlanePoint Least{ std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max() };
  PlanePoint Greatest{ std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min() };
};
}

#endif
