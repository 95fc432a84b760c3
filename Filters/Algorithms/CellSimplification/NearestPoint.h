// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the nearest of some points in plan (a k-d tree, Bentley 1975).

#ifndef SeismicHorizonsNearestPoint_h
#define SeismicHorizonsNearestPoint_h

#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class NearestPoint
{
public:
  /// Brings `points`, at least one, into the order of the tree: the middle one divides the others by x, the middle one
  /// of each half these by y, and so on. Takes about n log n steps. Keeps references; `plane` holds the place of each
  /// point by its number.
  NearestPoint(const std::vector<PlanePoint>& plane, std::vector<PointId>& points);

  /// The point nearest to a place; of several that of least number. Takes about log n steps, except where very many are
  /// about equally near.
  PointId Find(const PlanePoint& place) const;

private:
  using Axis = std::int32_t PlanePoint::*;
  struct Best
  {
    PointId Point;
    std::int64_t SquaredDistance;
  };

  static Axis Other(Axis axis) { return axis == &PlanePoint::X ? &PlanePoint::Y : &PlanePoint::X; }
  void Divide(std::size_t first, std::size_t last, Axis axis);
  void Search(std::size_t first, std::size_t last, Axis axis, const PlanePoint& place, Best& best) const;
  void Consider(std::size_t n, const PlanePoint& place, Best& best) const;
  const PlanePoint& PlaceOf(std::size_t n) const { return this->Plane[std::size_t(this->Points[n])]; }

  static constexpr std::size_t Few = 8; // points that are not divided

  const std::vector<PlanePoint>& Plane;
  std::vector<PointId>& Points;
};
}

#endif
