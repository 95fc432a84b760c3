// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

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
  PointId Target = NoPoint; // kept point that represents it
};

/// Sorted by Point.
using DroppedPoints = std::vector<DroppedPoint>;

inline PointId NumberWithout(const DroppedPoints& dropped, PointId point)
{
  const auto after = std::lower_bound(
    dropped.begin(), dropped.end(), point, [](const DroppedPoint& one, PointId id) { return one.Point < id; });
  return point - PointId(after - dropped.begin());
}

/// All points of the loops must be kept.
inline Loops RenumberWithout(const DroppedPoints& dropped, const Loops& loops)
{
  return loops.RenumberedBy([&dropped](PointId point) { return NumberWithout(dropped, point); });
}

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
