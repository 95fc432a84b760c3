// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestPoint.h"

#include "Common/PlaneGeometry.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
NearestPoint::NearestPoint(const std::vector<PlanePoint>& plane, std::vector<PointId>& points)
  : Plane(plane)
  , Points(points)
{
  this->Divide(0, points.size(), &PlanePoint::X);
}

//----------------------------------------------------------------------------------------------------------------------
void NearestPoint::Divide(std::size_t first, std::size_t last, Axis axis)
{
  if (last - first <= Few)
  {
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [this](std::size_t n) { return this->Points.begin() + std::ptrdiff_t(n); };
  std::nth_element(at(first), at(middle), at(last),
    [&](PointId a, PointId b) { return this->Plane[std::size_t(a)].*axis < this->Plane[std::size_t(b)].*axis; });
  this->Divide(first, middle, Other(axis));
  this->Divide(middle + 1, last, Other(axis));
}

//----------------------------------------------------------------------------------------------------------------------
PointId NearestPoint::Find(const PlanePoint& place) const
{
  Best best{ NoPoint, std::numeric_limits<std::int64_t>::max() };
  this->Search(0, this->Points.size(), &PlanePoint::X, place, best);
  return best.Point;
}

//----------------------------------------------------------------------------------------------------------------------
void NearestPoint::Search(std::size_t first, std::size_t last, Axis axis, const PlanePoint& place, Best& best) const
{
  if (last - first <= Few)
  {
    for (std::size_t n = first; n < last; ++n)
    {
      this->Consider(n, place, best);
    }
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  this->Consider(middle, place, best);
  const std::int64_t beyond = std::int64_t(place.*axis) - this->PlaceOf(middle).*axis;
  const auto low = [&]() { this->Search(first, middle, Other(axis), place, best); };
  const auto high = [&]() { this->Search(middle + 1, last, Other(axis), place, best); };
  beyond <= 0 ? low() : high();
  // Not less: a point as near as the best may have a lesser number.
  if (beyond * beyond <= best.SquaredDistance)
  {
    beyond <= 0 ? high() : low();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void NearestPoint::Consider(std::size_t n, const PlanePoint& place, Best& best) const
{
  const PointId point = this->Points[n];
  const std::int64_t distance = SquaredDistance(this->PlaceOf(n), place);
  if (std::tie(distance, point) < std::tie(best.SquaredDistance, best.Point))
  {
    best = { point, distance };
  }
}
}
