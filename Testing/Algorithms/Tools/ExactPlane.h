// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plane geometry of the checkers, in numbers of 128 bits: nothing is shared with what they check.

#ifndef SeismicHorizonsExactPlane_h
#define SeismicHorizonsExactPlane_h

#include "Common/Base/Portable.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace ExactPlane
{
using SeismicHorizons::Loops;
using SeismicHorizons::PlanePoint;
using SeismicHorizons::MeshChecker::SideOfCircle;
using SeismicHorizons::MeshChecker::Turn;
using Wide = SeismicHorizons::Int128;

inline int SignOf(Wide value)
{
  return int(value > 0) - int(value < 0);
}

/// Twice the area between the origin and the vectors from there to a and to b: positive from a to the left.
inline Wide Cross(const PlanePoint& a, const PlanePoint& b)
{
  return Wide(a.X) * b.Y - Wide(a.Y) * b.X;
}

/// Whether two segments cross in one point that is an end of neither.
inline bool DoCross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
  return SignOf(Turn(a, b, c)) * SignOf(Turn(a, b, d)) < 0 && SignOf(Turn(c, d, a)) * SignOf(Turn(c, d, b)) < 0;
}

/// Whether p lies on the segment from a to b, its ends included.
inline bool IsOnSegment(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return Turn(a, b, p) == 0 && std::min(a.X, b.X) <= p.X && p.X <= std::max(a.X, b.X) && std::min(a.Y, b.Y) <= p.Y &&
    p.Y <= std::max(a.Y, b.Y);
}

/// Columns along the longer axis.
inline int Apart(const PlanePoint& a, const PlanePoint& b)
{
  return std::max(std::abs(a.X - b.X), std::abs(a.Y - b.Y));
}

/// Whether a place is inside a set of loops, on them, or outside: 1, 0 or -1.
int Locate(const std::vector<PlanePoint>& places, const Loops& boundary, const PlanePoint& place);
}

#endif
