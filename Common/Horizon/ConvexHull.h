// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsConvexHull_h
#define SeismicHorizonsConvexHull_h

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// Counter-clockwise, without corners on the line between others (Andrew 1979, "Another efficient algorithm for convex hulls in
/// two dimensions").
inline std::vector<Eigen::Vector2d> FindHull(std::vector<Eigen::Vector2d> places)
{
  assert(!places.empty());
  std::sort(places.begin(), places.end(),
    [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
    { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Eigen::Vector2d> hull;
  const auto turnsRight = [&hull](const Eigen::Vector2d& place)
  {
    const Eigen::Vector2d &a = hull[hull.size() - 2], b = hull.back() - a, c = place - a;
    return b.x() * c.y() - b.y() * c.x() <= 0.0;
  };
  for (const bool isLower : { true, false })
  {
    const std::size_t begin = hull.size();
    for (const Eigen::Vector2d& place : places)
    {
      while (hull.size() >= begin + 2 && turnsRight(place))
      {
        hull.pop_back();
      }
      hull.push_back(place);
    }
    hull.pop_back();
    if (isLower)
    {
      std::reverse(places.begin(), places.end());
    }
  }
  return hull.empty() ? places : hull;
}
}

#endif
