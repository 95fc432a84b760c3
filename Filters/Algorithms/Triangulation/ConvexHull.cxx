// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ConvexHull.h"

#include "Common/Predicates.h"

#include <algorithm>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
/// A chain of points from the first to the last that has all others to its right or on it, and turns to the right only.
template <typename Iterator>
std::vector<PointId> MakeChain(Iterator first, Iterator last, const std::vector<PlanePoint>& places)
{
  const auto at = [&places](PointId point) { return places[std::size_t(point)]; };
  std::vector<PointId> chain;
  for (; first != last; ++first)
  {
    while (chain.size() > 1 && SignedArea(at(chain[chain.size() - 2]), at(chain.back()), at(*first)) > 0)
    {
      chain.pop_back();
    }
    chain.push_back(*first);
  }
  return chain;
}
}

//----------------------------------------------------------------------------------------------------------------------
Loops FindConvexHull(const std::vector<PlanePoint>& places)
{
  std::vector<PointId> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&places](PointId a, PointId b) { return places[std::size_t(a)] < places[std::size_t(b)]; });
  const std::vector<PointId> upper = MakeChain(order.begin(), order.end(), places);
  const std::vector<PointId> lower = MakeChain(order.rbegin(), order.rend(), places);
  Loops hull;
  std::for_each(upper.begin(), upper.end(), [&hull](PointId point) { hull.Append(point); });
  for (std::size_t n = 1; n + 1 < lower.size(); ++n)
  {
    hull.Append(lower[n]);
  }
  hull.Close();
  return hull;
}
}
