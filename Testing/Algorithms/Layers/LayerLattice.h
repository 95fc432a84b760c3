// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What checkers of layers know of columns, horizons and faulted links.

#ifndef SeismicHorizonsLayerLattice_h
#define SeismicHorizonsLayerLattice_h

#include "Filters/Algorithms/Layers/LayerPlan.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace LayerChecker
{
using namespace SeismicHorizons;

using Column = std::pair<int, int>; // x, y

struct Horizon
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Heights;
};

inline std::vector<HorizonView> ViewsOf(const std::vector<Horizon>& horizons)
{
  std::vector<HorizonView> views;
  for (const Horizon& horizon : horizons)
  {
    views.push_back({ horizon.Columns, horizon.Heights.data() });
  }
  return views;
}

/// The corners that cuts leave of a block, given its lower left column: 4 for all, 0 to 3 for a half without that
/// corner (lower left, lower right, upper left, upper right), -1 for none.
inline int LeftByCuts(const LinkCuts* cuts, const Column& block)
{
  if (!cuts)
  {
    return 4;
  }
  const PlanePoint least = { block.first, block.second };
  const bool isCut[4] = { cuts->IsCutEast(least), cuts->IsCutNorth({ least.X + 1, least.Y }),
    cuts->IsCutEast({ least.X, least.Y + 1 }), cuts->IsCutNorth(least) }; // around the block: below, right, above, left
  const int corners[4] = { 0, 1, 3, 2 }; // between the last side and the next
  const auto number = std::count(isCut, isCut + 4, true);
  for (int n = 0; n < 4 && number == 2; ++n)
  {
    if (isCut[(n + 3) % 4] && isCut[n])
    {
      return corners[n];
    }
  }
  return number == 0 ? 4 : -1;
}

/// Twice the area of a, b, p.
inline std::int64_t Turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p)
{
  return std::int64_t(b.X - a.X) * (p.Y - a.Y) - std::int64_t(b.Y - a.Y) * (p.X - a.X);
}
}

#endif
