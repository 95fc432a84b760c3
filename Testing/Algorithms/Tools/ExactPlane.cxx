// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExactPlane.h"

namespace ExactPlane
{
//----------------------------------------------------------------------------------------------------------------------
int Locate(const std::vector<PlanePoint>& places, const Loops& boundary, const PlanePoint& place)
{
  bool inside = false;
  bool on = false;
  boundary.ForEachEdge(
    [&](SeismicHorizons::PointId from, SeismicHorizons::PointId to)
    {
      const PlanePoint& a = places[std::size_t(from)];
      const PlanePoint& b = places[std::size_t(to)];
      if (std::max(a.Y, b.Y) < place.Y || std::min(a.Y, b.Y) > place.Y)
      {
        return;
      }
      on = on || IsOnSegment(a, b, place);
      // A ray from the place to the right crosses an edge that passes its height with the place to its left.
      const PlanePoint& low = a.Y < b.Y ? a : b;
      const PlanePoint& high = a.Y < b.Y ? b : a;
      if (low.Y <= place.Y && place.Y < high.Y && Turn(low, high, place) > 0)
      {
        inside = !inside;
      }
    });
  return on ? 0 : (inside ? 1 : -1);
}
}
