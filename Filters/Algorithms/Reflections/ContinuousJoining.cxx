// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grows surfaces one after the other (Prim 1957), each from the strongest free pick, over the best link into a column
// that it does not have. Links are not refused for what lies beyond, so strong events stay whole where parts would not
// fit.

#include "SurfaceJoining.h"

#include "Common/CountingSort.h"

#include <cassert>
#include <queue>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// Strengths are compared by the upper half of their bits.
std::vector<PointId> SortByStrength(const ReflectionPicks& picks)
{
  constexpr std::int64_t keys = 1 << 15; // strengths have no sign
  const auto keyOf = [&picks](PointId pick) { return keys - 1 - picks.CoarseStrengthOf(pick); };
  CountingSort<std::int32_t> sort(keys);
  for (PointId pick = 0; pick < picks.Size(); ++pick)
  {
    sort.Count(keyOf(pick));
  }
  sort.EndCounting();
  std::vector<PointId> sorted(picks.Size());
  for (PointId pick = 0; pick < picks.Size(); ++pick)
  {
    sorted[sort.NextPosition(keyOf(pick))] = pick;
  }
  return sorted;
}

struct RimLink
{
  float Score = 0.0F;
  PointId To = NoPoint;

  /// std::priority_queue returns the largest first.
  friend bool operator<(const RimLink& a, const RimLink& b)
  {
    return a.Score != b.Score ? a.Score < b.Score : a.To > b.To;
  }
};

class Growth
{
public:
  Growth(const ReflectionPicks& picks, const ReflectionLinks& links)
    : Picks(picks)
    , Links(links)
    , Labels(picks.Places.size(), NoPoint)
    , LastInColumn(picks.Starts.size() - 1, NoPoint)
    , Columns(picks.ListColumns())
  {
  }

  RawVector<PointId> Run(const Monitor& monitor)
  {
    constexpr std::size_t batch = 1 << 16;
    const std::vector<PointId> seeds = SortByStrength(this->Picks);
    for (std::size_t n = 0; n < seeds.size(); ++n)
    {
      if (n % batch == 0)
      {
        monitor.Progress(double(n) / double(seeds.size()));
      }
      if (this->Labels[seeds[n]] == NoPoint)
      {
        this->Grow(seeds[n]);
      }
    }
    return std::move(this->Labels);
  }

private:
  void Grow(PointId seed)
  {
    this->Rim.push({ 0.0F, seed });
    while (!this->Rim.empty())
    {
      const PointId pick = this->Rim.top().To;
      assert(pick != NoPoint);
      this->Rim.pop();
      PointId& last = this->LastInColumn[this->Columns[pick]];
      if (this->Labels[pick] == NoPoint && last != seed)
      {
        this->Labels[pick] = seed;
        last = seed;
        this->AddRim(pick);
      }
    }
  }

  void AddRim(PointId pick)
  {
    this->Links.ForEachOf(pick,
      [&](PointId to, PointId owner, int direction)
      {
        if (this->Labels[to] == NoPoint)
        {
          this->Rim.push({ float(this->Links.Score(owner, direction)), to });
        }
      });
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  RawVector<PointId> Labels;
  std::vector<PointId> LastInColumn;
  RawVector<std::int32_t> Columns;
  std::priority_queue<RimLink> Rim;
};
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> JoinContinuously(const ReflectionPicks& picks, const ReflectionLinks& links, const Monitor& monitor)
{
  return Growth(picks, links).Run(monitor);
}
}
