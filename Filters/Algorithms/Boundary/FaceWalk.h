// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The walk around one face of a plane graph that connects points of a horizon by hops. At every point the walk sweeps
// clockwise over the hops of the graph, beginning after the one back to where it came from, and leaves by the first
// that the sweep meets; the hop back comes last. So the face lies to the left of all hops of the walk: the outer face
// is walked clockwise around the patch, and the face of a hole counter-clockwise, with the surface to the right in
// either case.

#ifndef SeismicHorizonsFaceWalk_h
#define SeismicHorizonsFaceWalk_h

#include "ColumnRaster.h"
#include "HopVectors.h"

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
/// A point of a walk, and the hop by which the walk leaves it: NoHop for a point alone. In the gap of a seam there is
/// no point (SeamGaps.h).
struct FaceStep
{
  PointId Point;
  HopId Hop;
};

/// Walks from the place `start` by the hop `first` until it is about to repeat that hop. `next(place, from)` gives the
/// first hop of the graph from a place that a clockwise sweep after `from` meets, or NoHop.
template <typename Next>
void WalkFace(const ColumnRaster& raster, const HopVectors& hops, std::int64_t start, HopId first, Next&& next,
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
      hop = next(place, hops.Opposite(hop));
    }
  } while (place != start || hop != first);
}

struct FaceSize
{
  std::int64_t TwiceArea = 0; // less than 0 for a face that is walked clockwise
  std::int64_t OnLoop = 0; // columns that the walk passes through the middles of, each as often as it does
};

inline FaceSize MeasureFace(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  FaceSize size;
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const FaceStep& step : steps)
  {
    if (step.Hop == NoHop)
    {
      return size;
    }
    const PlanePoint& vector = hops.Vector(step.Hop);
    size.TwiceArea += x * vector.Y - y * vector.X;
    size.OnLoop += hops.NumberOfParts(step.Hop);
    x += vector.X;
    y += vector.Y;
  }
  return size;
}

/// How many columns lie strictly inside a face that is walked counter-clockwise, by Pick's theorem; 0 for one that is
/// walked clockwise, or has no area. A column that the walk visits twice counts twice, as if the loop had two there.
inline std::int64_t ColumnsInside(const HopVectors& hops, const std::vector<FaceStep>& steps)
{
  const FaceSize size = MeasureFace(hops, steps);
  return size.TwiceArea > 0 ? (size.TwiceArea - size.OnLoop) / 2 + 1 : 0;
}

/// Leaves out the steps in gaps of seams. The columns inside are counted before.
inline void DropStepsInGaps(std::vector<FaceStep>& steps)
{
  steps.erase(std::remove_if(steps.begin(), steps.end(), [](const FaceStep& step) { return step.Point == NoPoint; }),
    steps.end());
}

/// Adds a walk as a loop that begins at its point of least x, then least y. When the walk visits that point several
/// times, the loop begins with the hop from there that a clockwise sweep from the south meets first. No step is in a
/// gap.
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
