// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cracks that faulted links leave open between the loops of a horizon.

#ifndef SeismicHorizonsCracks_h
#define SeismicHorizonsCracks_h

#include "Types.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// A crack is bounded by its cutoffs, which are edges of loops with the crack to their left, and by open ends, where it
/// reaches the outside or missing points:
///
///     o---o---o---o---o---o
///         :           |           o    points
///         :           |           -    cutoffs, with the surface beyond them
///     o---o---o---o---o---o       :    an open end, which leads downwards, as the crack is to its left
///
struct Cracks
{
  /// Between points of loops, which stay when loops are simplified, with the crack to the left.
  std::vector<Edge> OpenEnds;
  /// The numbers of the loops that are cutoffs all along, ascending: among them those of cracks without an open end.
  std::vector<std::size_t> Loops;

  std::vector<PointId> PointsOfOpenEnds() const
  {
    std::vector<PointId> points;
    for (const Edge& openEnd : this->OpenEnds)
    {
      points.insert(points.end(), { openEnd.From, openEnd.To });
    }
    return points;
  }
};
}

#endif
