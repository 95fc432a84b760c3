// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Few points of a horizon that are dropped, and the numbers that the others have then.

#ifndef SeismicHorizonsDroppedPoints_h
#define SeismicHorizonsDroppedPoints_h

#include "KeptPoints.h"
#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
struct DroppedPoint
{
  PointId Point = NoPoint;
  PointId Target = NoPoint; // the point, which is kept, that represents it
};

/// By ascending points.
using DroppedPoints = std::vector<DroppedPoint>;

/// The number of a point that is kept.
inline PointId NumberWithout(const DroppedPoints& dropped, PointId point)
{
  const auto after = std::lower_bound(
    dropped.begin(), dropped.end(), point, [](const DroppedPoint& one, PointId id) { return one.Point < id; });
  return point - PointId(after - dropped.begin());
}

/// Loops over points that are all kept, by their numbers.
inline Loops RenumberWithout(const DroppedPoints& dropped, const Loops& loops)
{
  return loops.RenumberedBy([&dropped](PointId point) { return NumberWithout(dropped, point); });
}

/// The points of a horizon that are not dropped.
inline KeptPoints KeepOthers(const DroppedPoints& dropped, std::size_t total)
{
  KeptPoints kept(total);
  PointId next = 0;
  for (const DroppedPoint& one : dropped)
  {
    kept.AppendRun(next, std::size_t(one.Point - next));
    next = one.Point + 1;
  }
  kept.AppendRun(next, total - std::size_t(next));
  return kept;
}
}

#endif
