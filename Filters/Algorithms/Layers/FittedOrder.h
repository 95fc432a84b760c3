// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts heights that were fitted to horizons of a stack in order.

#ifndef SeismicHorizonsFittedOrder_h
#define SeismicHorizonsFittedOrder_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Types.h"
#include "Crossings.h"
#include "Filters/Algorithms/Decimation/HeightMesh.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Fitted heights out of order get their mean, which does not increase the largest error. Horizons stay one if they are
/// one at the neighbours, too, or on a pinch-out line: else noise would pinch thin layers everywhere.
class FittedOrder
{
public:
  /// `heights` has the thickness of layers behind the horizons.
  FittedOrder(const ColumnIndex& index, const HeightStack& heights, std::size_t horizons,
    const std::vector<unsigned char>& isOnLine, bool downwards)
    : Heights(heights)
    , Horizons(horizons)
    , Index(index)
    , IsOnLine(isOnLine)
    , GrowDownwards(downwards)
  {
  }

  /// The mesh may have a level horizon before the stack.
  void Apply(const HeightMesh& mesh, std::vector<InnerHeights>& fitted) const;

private:
  bool AreOne(std::size_t layer, PointId point) const;

  const HeightStack& Heights;
  const std::size_t Horizons;
  const ColumnIndex& Index; // with an empty rim
  const std::vector<unsigned char>& IsOnLine;
  const bool GrowDownwards;
};
}

#endif
