// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlainGrowth.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <queue>

namespace SeismicHorizons
{
namespace
{
struct RimLink
{
  float Score = -std::numeric_limits<float>::infinity();
  PointId To = NoPoint;
  int Reach = 0; // in columns

  /// std::priority_queue returns the largest first.
  friend bool operator<(const RimLink& a, const RimLink& b)
  {
    return a.Score != b.Score ? a.Score < b.Score : (a.To != b.To ? a.To > b.To : a.Reach > b.Reach);
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
GrownPicks GrowPlainly(const ReflectionPicks& picks, const RawVector<std::int32_t>& columns, const GrowthLinks& links,
  const std::vector<PointId>& starts, const GrowthRules& rules)
{
  GrownPicks grown;
  grown.Picks.assign(picks.Starts.size() - 1, NoPoint);
  std::priority_queue<RimLink> rim;
  std::vector<RimLink> best(grown.Picks.size()); // so far, by column; only these are ever followed
  const auto isFree = [&](std::int32_t column) { return starts[column] == NoPoint && grown.Picks[column] == NoPoint; };
  const auto addRim = [&](PointId pick, int distance)
  {
    links.ForEachOf(pick,
      [&](PointId to, double correlation)
      {
        const std::int32_t column = columns[to];
        if (correlation < rules.SmallestCorrelation || !isFree(column) ||
          (rules.IsCareful && !AreOfLikeStrength(picks, pick, to)))
        {
          return;
        }
        const int next = rules.Distances ? (*rules.Distances)[column] : distance + 1;
        if (next > rules.Reach)
        {
          grown.Stops.push_back(column);
          return;
        }
        const PickDepth step = rules.IsCareful ? std::abs(picks.Places[to] - picks.Places[pick]) : 0;
        const RimLink link{ float(LinkScore(correlation, step)), to, next };
        if (best[column] < link)
        {
          best[column] = link;
          rim.push(link);
        }
      });
  };
  for (const PointId pick : starts)
  {
    if (pick != NoPoint)
    {
      addRim(pick, 0);
    }
  }
  while (!rim.empty())
  {
    const RimLink link = rim.top();
    rim.pop();
    PointId& place = grown.Picks[columns[link.To]];
    if (place == NoPoint)
    {
      place = link.To;
      addRim(link.To, link.Reach);
    }
  }
  std::sort(grown.Stops.begin(), grown.Stops.end());
  grown.Stops.erase(std::unique(grown.Stops.begin(), grown.Stops.end()), grown.Stops.end());
  return grown;
}
}
