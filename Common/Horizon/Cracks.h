// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCracks_h
#define SeismicHorizonsCracks_h

#include "Types.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// A crack along faulted links is bounded by cutoffs, which are edges of loops with the crack to their left, and by
/// open ends at the outside or at missing points:
///
///     o---o---o---o---o---o
///         :           |           o    points
///         :           |           -    cutoffs, with the surface beyond them
///     o---o---o---o---o---o       :    an open end, directed downwards: the crack is to its left
///
struct Cracks
{
  /// Simplification keeps these points; the crack is to the left.
  std::vector<Edge> OpenEnds;
  /// Ascending indices of loops that are cutoffs only.
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
