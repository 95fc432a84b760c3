// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExactPlane.h"

namespace ExactPlane
{
//----------------------------------------------------------------------------------------------------------------------
// By cofactors of the 4 x 4 determinant.
int SideOfCircle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  const auto lift = [&d](const PlanePoint& p) { return Wide(p.X - d.X) * (p.X - d.X) + Wide(p.Y - d.Y) * (p.Y - d.Y); };
  return SignOf(lift(a) * Turn(d, b, c) - lift(b) * Turn(d, a, c) + lift(c) * Turn(d, a, b));
}

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
