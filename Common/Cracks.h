// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cracks that cut links leave open between the loops of a horizon.

#ifndef SeismicHorizonsCracks_h
#define SeismicHorizonsCracks_h

#include "Types.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// A crack is bounded by its lips, which are edges of loops with the crack to their left, and by mouths, where it opens
/// to the outside or to a gap of missing points:
///
///     o---o---o---o---o---o
///         :           |           o    points
///         :           |           -    lips, with the surface beyond them
///     o---o---o---o---o---o       :    the mouth, which leads downwards, as the crack is to its left
///
struct Cracks
{
  /// Between points of loops, which stay when loops are simplified, with the crack to the left.
  std::vector<Edge> Mouths;
  /// The numbers of the loops that are lips all along, ascending: those of a crack without a mouth are among them.
  std::vector<std::size_t> Loops;

  std::vector<PointId> EndsOfMouths() const
  {
    std::vector<PointId> ends;
    for (const Edge& mouth : this->Mouths)
    {
      ends.insert(ends.end(), { mouth.From, mouth.To });
    }
    return ends;
  }
};
}

#endif
