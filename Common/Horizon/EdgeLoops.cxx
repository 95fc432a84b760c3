// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeLoops.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
Loops JoinEdges(std::vector<Edge> edges)
{
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b) { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
  std::vector<unsigned char> isUsed(edges.size(), 0);
  const auto nextFrom = [&](PointId point)
  {
    const auto first = std::lower_bound(
      edges.begin(), edges.end(), point, [](const Edge& edge, PointId other) { return edge.From < other; });
    auto next = std::size_t(first - edges.begin());
    while (next < edges.size() && edges[next].From == point && isUsed[next] != 0)
    {
      ++next;
    }
    return next < edges.size() && edges[next].From == point ? next : edges.size();
  };
  Loops loops;
  for (std::size_t start = 0; start < edges.size(); ++start)
  {
    const bool isNew = isUsed[start] == 0;
    for (std::size_t next = start; next < edges.size() && isUsed[next] == 0; next = nextFrom(edges[next].To))
    {
      isUsed[next] = 1;
      loops.Append(edges[next].From);
    }
    if (isNew)
    {
      loops.Close();
    }
  }
  return loops;
}
}
