// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights that were fitted to horizons of a stack, in order.

#ifndef SeismicHorizonsFittedOrder_h
#define SeismicHorizonsFittedOrder_h

#include "Common/ColumnIndex.h"
#include "Common/Types.h"
#include "Crossings.h"
#include "Decimation/HeightMesh.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Puts the fitted heights of each vertex in order: the mean of those that are not. That is no farther from ordered
/// heights than they were at most. Horizons that are one at a column and at its neighbours stay one, and so do those
/// at the ends of pinch-out lines: were it one column alone, noise would pinch thin layers everywhere.
class FittedOrder
{
public:
  /// Of so many horizons; what follows them in the stack are the heights of layers, each that of the horizon above less
  /// that of the one below.
  FittedOrder(const ColumnIndex& index, const HeightStack& heights, std::size_t horizons,
    const std::vector<unsigned char>& isOnLine, bool downwards)
    : Heights(heights)
    , Horizons(horizons)
    , Index(index)
    , IsOnLine(isOnLine)
    , GrowDownwards(downwards)
  {
  }

  /// Those of a mesh, which may have a level horizon before the stack.
  void Apply(const HeightMesh& mesh, std::vector<InnerHeights>& fitted) const;

private:
  bool IsPinched(std::size_t layer, PointId point) const;
  bool HasLayer(std::size_t layer, PointId point) const;
  bool AreOne(std::size_t layer, PointId point) const;

  const HeightStack& Heights;
  const std::size_t Horizons;
  const ColumnIndex& Index; // with an empty rim
  const std::vector<unsigned char>& IsOnLine;
  const bool GrowDownwards;
};
}

#endif
