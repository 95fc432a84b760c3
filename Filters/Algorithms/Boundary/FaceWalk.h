// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The walk around one face of a plane graph whose corners are points of a horizon and whose edges are hops. At every
// point it sweeps clockwise, beginning after the hop it came by, and leaves by the first hop of the graph that it
// meets; the hop back comes last. So the face lies to the left of all its hops: the outer face is walked clockwise
// around the patch, and the face of a hole counter-clockwise, with the surface to the right in either case.

#ifndef SeismicHorizonsFaceWalk_h
#define SeismicHorizonsFaceWalk_h

#include "ColumnRaster.h"
#include "HopVectors.h"

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
/// A point of a walk and the hop by which it is left; NoHop for a point alone.
struct FaceStep
{
  PointId Point;
  HopId Hop;
};

/// Walks on from a place by a hop of the graph until it is about to repeat that hop. `sweep(place, from)` gives the
/// first hop of the graph after `from`, in clockwise order, or NoHop.
template <typename Sweep>
void WalkFace(const ColumnRaster& raster, const HopVectors& hops, std::int64_t start, HopId first, Sweep&& sweep,
  std::vector<FaceStep>& steps)
{
  steps.clear();
  std::int64_t place = start;
  HopId hop = first;
  do
  {
    steps.push_back({ raster[place], hop });
    if (hop != NoHop)
    {
      place += hops.Offset(hop);
      hop = sweep(place, hops.Opposite(hop));
    }
  } while (place != start || hop != first);
}

/// How many columns lie strictly inside a face that is walked counter-clockwise, by Pick's theorem; 0 for one that is
/// walked clockwise, or has no area. A column the walk visits twice counts twice on the border, as it would if the
/// border were pulled apart there.
inline std::int64_t ColumnsInside(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  std::int64_t twiceArea = 0;
  std::int64_t onBorder = 0;
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const FaceStep& step : steps)
  {
    if (step.Hop == NoHop)
    {
      return 0;
    }
    const PlanePoint& vector = hops.Vector(step.Hop);
    twiceArea += x * vector.Y - y * vector.X;
    onBorder += hops.Parts(step.Hop);
    x += vector.X;
    y += vector.Y;
  }
  return twiceArea > 0 ? (twiceArea - onBorder) / 2 + 1 : 0;
}

/// Adds a walk as a loop that begins where the contract says: at the point of least x, then least y. The walk can visit
/// that point several times; of its hops from there the one that comes first in a clockwise sweep from the south, where
/// all is empty, begins.
inline void AppendLoop(const std::vector<PlanePoint>& columns, std::vector<FaceStep>& steps, Loops& loops)
{
  const auto first = std::min_element(steps.begin(), steps.end(),
    [&columns](const FaceStep& a, const FaceStep& b)
    {
      const PlanePoint& columnA = columns[std::size_t(a.Point)];
      const PlanePoint& columnB = columns[std::size_t(b.Point)];
      return columnA == columnB ? a.Hop < b.Hop : columnA < columnB;
    });
  std::rotate(steps.begin(), first, steps.end());
  for (const FaceStep& step : steps)
  {
    loops.Append(step.Point);
  }
  loops.Close();
}
}

#endif
