// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NearestPoint.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
NearestPoint::NearestPoint(const std::vector<PlanePoint>& plane, std::vector<PointId>& points)
  : Plane(plane)
  , Points(points)
{
  if (points.size() > Few)
  {
    this->Divide({ 0, 0, points.size() });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void NearestPoint::Divide(const Range& range)
{
  PlaneBox box;
  const auto at = [this](std::size_t n) { return this->Points.begin() + std::ptrdiff_t(n); };
  std::for_each(at(range.First), at(range.Last), [&](PointId point) { box.Add(this->Plane[std::size_t(point)]); });
  this->Boxes.resize(std::max(this->Boxes.size(), range.Node + 1));
  this->Boxes[range.Node] = box;
  if (range.IsLeaf())
  {
    return;
  }
  const bool isWide = std::int64_t(box.Greatest.X) - box.Least.X >= std::int64_t(box.Greatest.Y) - box.Least.Y;
  const auto axis = isWide ? &PlanePoint::X : &PlanePoint::Y;
  std::nth_element(at(range.First), at(range.Middle()), at(range.Last),
    [&](PointId a, PointId b) { return this->Plane[std::size_t(a)].*axis < this->Plane[std::size_t(b)].*axis; });
  this->Divide(range.Low());
  this->Divide(range.High());
}

//----------------------------------------------------------------------------------------------------------------------
PointId NearestPoint::Find(const PlanePoint& place) const
{
  Best best{ NoPoint, std::numeric_limits<std::int64_t>::max() };
  this->Search({ 0, 0, this->Points.size() }, place, best);
  return best.Point;
}

//----------------------------------------------------------------------------------------------------------------------
void NearestPoint::Search(const Range& range, const PlanePoint& place, Best& best) const
{
  if (range.IsLeaf())
  {
    for (std::size_t n = range.First; n < range.Last; ++n)
    {
      const PointId point = this->Points[n];
      const std::int64_t distance = SquaredDistance(this->Plane[std::size_t(point)], place);
      if (std::tie(distance, point) < std::tie(best.SquaredDistance, best.Point))
      {
        best = { point, distance };
      }
    }
    return;
  }
  Range nearer = range.Low();
  Range farther = range.High();
  std::int64_t near = this->SquaredDistanceToBox(nearer, place);
  std::int64_t far = this->SquaredDistanceToBox(farther, place);
  if (far < near)
  {
    std::swap(nearer, farther);
    std::swap(near, far);
  }
  // Not less: a point as near as the best may have a lesser number.
  if (near <= best.SquaredDistance)
  {
    this->Search(nearer, place, best);
  }
  if (far <= best.SquaredDistance)
  {
    this->Search(farther, place, best);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t NearestPoint::SquaredDistanceToBox(const Range& range, const PlanePoint& place) const
{
  const PlaneBox& box = this->Boxes[range.Node];
  return SquaredDistance(
    place, { std::clamp(place.X, box.Least.X, box.Greatest.X), std::clamp(place.Y, box.Least.Y, box.Greatest.Y) });
}
}
