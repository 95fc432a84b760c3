// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Parts of surfaces with picks of the guide are taken. If a part passes more picks elsewhere than it has, its picks
// are strays; if few, it ran into another event and is cut half-way.
// 2. The surface grows from all its picks at once, best link first (Prim 1957), into free columns. Parts growing from
// both sides stop each other.
// 3. Parts that growth runs along are taken whole, as they are more reliable, and the surface grows anew.

#include "GuidedJoining.h"

#include "Common/Base/CountingSort.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <queue>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Growth replaces parts with fewer picks.
constexpr PointId SmallestPart = 30;

// Other events may hold this share of a part's columns.
constexpr double LargestSeededConflict = 0.3;
constexpr double LargestGrownConflict = 0.1;

// A part is found if it shares this number of columns with growth, and this fraction at the same picks.
constexpr PointId FewestCommonColumns = 10;
constexpr double SmallestAgreement = 0.7;

// Picks are strays if their part passes this multiple of other picks elsewhere.
constexpr std::int64_t FewestMissesOfStray = 3;

// Later rounds find no parts worth taking.
constexpr int Rounds = 2;

struct RimLink
{
  float Score = 0.0F;
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
class GuidedJoining::Follower
{
public:
  explicit Follower(const GuidedJoining& joining)
    : Joining(joining)
    , Picks(joining.Picks)
    , Found(joining.Picks.Starts.size() - 1, NoPoint)
    , Grown(this->Found)
  {
  }

  GuidedSurface Run(std::vector<GuideSeed> seeds)
  {
    std::sort(seeds.begin(), seeds.end(), [](const GuideSeed& a, const GuideSeed& b) { return a.Column < b.Column; });
    GuidedSurface result;
    this->Seeds = std::move(seeds);
    this->DropStrays(result.Strays);
    for (const GuideSeed& seed : this->Seeds)
    {
      this->Found[seed.Column] = seed.Pick;
    }
    this->MeasureDistances();
    for (const PointId part : ListParts(this->CountVotes(), [](const Votes& vote) { return vote.Hits >= vote.Misses; }))
    {
      this->TakePart(part, LargestSeededConflict);
    }
    this->Grow();
    for (int round = 0; round < Rounds && this->TakeGrownParts(); ++round)
    {
      this->Grow();
    }
    this->Write(result);
    return result;
  }

private:
  PointId PartOf(PointId pick) const
  {
    const PointId part = this->Joining.Surfaces[pick];
    return part != NoPoint && this->SizeOf(part) >= SmallestPart ? part : NoPoint;
  }
  PointId SizeOf(PointId part) const { return this->Joining.Starts[part + 1] - this->Joining.Starts[part]; }

  template <typename Visit>
  void ForEachMember(PointId part, Visit&& visit) const
  {
    for (PointId n = this->Joining.Starts[part]; n < this->Joining.Starts[part + 1]; ++n)
    {
      visit(this->Joining.Members[n]);
    }
  }

  PointId MemberIn(PointId part, std::int64_t column) const
  {
    for (PointId pick = this->Picks.Begin(column); pick < this->Picks.End(column); ++pick)
    {
      if (this->Joining.Surfaces[pick] == part)
      {
        return pick;
      }
    }
    return NoPoint;
  }

  bool AreSameEvent(PointId a, PointId b) const
  {
    return std::abs(this->Picks.Places[a] - this->Picks.Places[b]) <= this->Joining.Quarter;
  }

  /// Hits are seeds on a part, misses are seeds that it passes elsewhere.
  struct Votes
  {
    std::int64_t Hits = 0;
    std::int64_t Misses = 0;
  };
  std::map<PointId, Votes> CountVotes() const
  {
    std::map<PointId, Votes> votes;
    for (const GuideSeed& seed : this->Seeds)
    {
      const PointId part = this->PartOf(seed.Pick);
      if (part != NoPoint)
      {
        ++votes[part].Hits;
      }
    }
    for (auto& [part, vote] : votes)
    {
      vote.Misses = std::int64_t(this->MissesOf(part).size());
    }
    return votes;
  }

  std::vector<PointId> MissesOf(PointId part) const
  {
    std::vector<PointId> misses;
    for (const GuideSeed& seed : this->Seeds)
    {
      const PointId member = this->MemberIn(part, seed.Column);
      if (member != NoPoint && !this->AreSameEvent(member, seed.Pick))
      {
        misses.push_back(member);
      }
    }
    return misses;
  }

  void DropStrays(std::vector<std::size_t>& strays)
  {
    const std::map<PointId, Votes> votes = this->CountVotes();
    const auto isStray = [&](const GuideSeed& seed)
    {
      const auto vote = votes.find(this->PartOf(seed.Pick));
      return vote != votes.end() && vote->second.Misses >= FewestMissesOfStray * vote->second.Hits;
    };
    for (const GuideSeed& seed : this->Seeds)
    {
      if (isStray(seed))
      {
        strays.push_back(seed.Number);
      }
    }
    std::sort(strays.begin(), strays.end());
    this->Seeds.erase(std::remove_if(this->Seeds.begin(), this->Seeds.end(), isStray), this->Seeds.end());
  }

  /// Distances take two passes, over the columns before and after.
  void MeasureDistances()
  {
    const auto [columns, rows] = this->Picks.Columns;
    this->Distances.assign(this->Found.size(), columns + rows);
    for (const GuideSeed& seed : this->Seeds)
    {
      this->Distances[seed.Column] = 0;
    }
    for (const int sign : { -1, 1 })
    {
      for (std::size_t n = 0; n < this->Distances.size(); ++n)
      {
        const auto column = std::int32_t(sign < 0 ? n : this->Distances.size() - 1 - n);
        this->ForEachNeighbour(column,
          [&](std::int64_t next)
          { this->Distances[column] = std::min(this->Distances[column], this->Distances[next] + 1); });
      }
    }
  }

  /// Returns wanted parts, most hits first.
  template <typename IsWanted>
  static std::vector<PointId> ListParts(const std::map<PointId, Votes>& votes, IsWanted&& isWanted)
  {
    std::vector<std::pair<std::int64_t, PointId>> parts;
    for (const auto& [part, vote] : votes)
    {
      if (isWanted(vote))
      {
        parts.push_back({ -vote.Hits, part });
      }
    }
    std::sort(parts.begin(), parts.end());
    std::vector<PointId> sorted(parts.size());
    std::transform(parts.begin(), parts.end(), sorted.begin(), [](const auto& part) { return part.second; });
    return sorted;
  }

  bool TakePart(PointId part, double largestConflict)
  {
    std::vector<PointId> members = this->MembersBesideMisses(part);
    std::int64_t conflicts = 0;
    std::int64_t news = 0;
    for (const PointId member : members)
    {
      const PointId found = this->Found[this->Joining.Columns[member]];
      conflicts += found != NoPoint && !this->AreSameEvent(found, member) ? 1 : 0;
      news += found == NoPoint ? 1 : 0;
    }
    if (double(conflicts) > largestConflict * double(members.size()) || news == 0)
    {
      return false;
    }
    for (const PointId member : members)
    {
      PointId& found = this->Found[this->Joining.Columns[member]];
      found = found == NoPoint ? member : found;
    }
    return true;
  }

  /// If the part passes seeds elsewhere, picks nearer to these are left out.
  std::vector<PointId> MembersBesideMisses(PointId part) const
  {
    std::vector<PointId> members;
    const std::vector<PointId> misses = this->MissesOf(part);
    std::map<PointId, bool> isNear; // to the surface
    std::vector<PointId> front;
    this->ForEachMember(part,
      [&](PointId member)
      {
        members.push_back(member);
        const std::int32_t column = this->Joining.Columns[member];
        if (!misses.empty() && (this->Found[column] == member || this->Grown[column] == member))
        {
          front.push_back(member);
          isNear[member] = true;
        }
      });
    if (misses.empty())
    {
      return members;
    }
    for (const PointId miss : misses)
    {
      front.push_back(miss);
      isNear[miss] = false;
    }
    for (std::size_t n = 0; n < front.size(); ++n) // breadth first
    {
      const bool near = isNear[front[n]];
      this->ForEachNeighbour(this->Joining.Columns[front[n]],
        [&](std::int64_t column)
        {
          const PointId next = this->MemberIn(part, column);
          if (next != NoPoint && isNear.insert({ next, near }).second)
          {
            front.push_back(next);
          }
        });
    }
    members.erase(std::remove_if(members.begin(), members.end(),
                    [&](PointId member)
                    {
                      const auto found = isNear.find(member);
                      return found == isNear.end() || !found->second;
                    }),
      members.end());
    return members;
  }

  template <typename Visit>
  void ForEachNeighbour(std::int32_t column, Visit&& visit) const
  {
    const int i = this->Picks.IOf(column);
    const int j = this->Picks.JOf(column);
    for (const ColumnStep& step : TraceSteps)
    {
      for (const int sign : { 1, -1 })
      {
        const int nextI = i + sign * step.I;
        const int nextJ = j + sign * step.J;
        if (nextI >= 0 && nextI < this->Picks.Columns[0] && nextJ >= 0 && nextJ < this->Picks.Columns[1])
        {
          visit(this->Picks.ColumnAt(nextI, nextJ));
        }
      }
    }
  }

  void Grow()
  {
    std::fill(this->Grown.begin(), this->Grown.end(), NoPoint);
    std::priority_queue<RimLink> rim;
    const auto addRim = [&](PointId pick, int reach)
    {
      if (reach < this->Joining.Options.GrowthReach)
      {
        const ReflectionLinks& links = this->Joining.Links;
        links.ForEachOf(pick,
          [&](PointId to, PointId owner, int direction)
          {
            const std::int32_t column = this->Joining.Columns[to];
            if (this->Found[column] == NoPoint && this->Grown[column] == NoPoint)
            {
              rim.push({ float(links.Score(owner, direction)), to, reach + 1 });
            }
          });
      }
    };
    for (const PointId pick : this->Found)
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
      PointId& place = this->Grown[this->Joining.Columns[link.To]];
      if (place == NoPoint)
      {
        place = link.To;
        addRim(link.To, link.Reach);
      }
    }
  }

  /// Returns whether any part was taken.
  bool TakeGrownParts()
  {
    std::map<PointId, Votes> votes;
    for (std::size_t column = 0; column < this->Grown.size(); ++column)
    {
      const PointId grown = this->Grown[column];
      for (PointId pick = this->Picks.Begin(column); grown != NoPoint && pick < this->Picks.End(column); ++pick)
      {
        if (const PointId part = this->PartOf(pick); part != NoPoint)
        {
          ++(pick == grown ? votes[part].Hits : votes[part].Misses);
        }
      }
    }
    const auto isLikeGrowth = [](const Votes& vote)
    {
      const std::int64_t common = vote.Hits + vote.Misses;
      return common >= FewestCommonColumns && double(vote.Hits) >= SmallestAgreement * double(common);
    };
    bool isAny = false;
    for (const PointId part : ListParts(votes, isLikeGrowth))
    {
      isAny |= this->TakePart(part, LargestGrownConflict);
    }
    return isAny;
  }

  void Write(GuidedSurface& result) const
  {
    auto seed = this->Seeds.begin();
    for (std::size_t column = 0; column < this->Found.size(); ++column)
    {
      const bool isFound = this->Found[column] != NoPoint;
      const bool isSeed = seed != this->Seeds.end() && std::size_t(seed->Column) == column;
      seed += isSeed ? 1 : 0;
      if (isFound || this->Grown[column] != NoPoint)
      {
        const PickOrigin origin = isSeed ? PickOrigin::Guide : (isFound ? PickOrigin::Part : PickOrigin::Growth);
        result.Picks.push_back(
          { isFound ? this->Found[column] : this->Grown[column], origin, this->Distances[column] });
      }
    }
  }

  const GuidedJoining& Joining;
  const ReflectionPicks& Picks;
  std::vector<GuideSeed> Seeds;
  std::vector<PointId> Found; // by column: seeds and parts
  std::vector<PointId> Grown;
  std::vector<int> Distances;
};

//----------------------------------------------------------------------------------------------------------------------
GuidedJoining::GuidedJoining(const ReflectionPicks& picks, const RawVector<PointId>& surfaces,
  const ReflectionLinks& links, double period, const GuidanceOptions& options)
  : Picks(picks)
  , Surfaces(surfaces)
  , Links(links)
  , Options(options)
  , Quarter(PickDepth(std::lround(period / 4.0 * DepthsPerSample)))
  , Columns(picks.ListColumns())
{
  CountingSort<PointId> sort(picks.Size());
  const auto forEach = [&](auto&& visit)
  {
    for (PointId pick = 0; pick < picks.Size(); ++pick)
    {
      if (surfaces[pick] != NoPoint)
      {
        visit(pick);
      }
    }
  };
  forEach([&](PointId pick) { sort.Count(surfaces[pick]); });
  sort.EndCounting();
  this->Members.resize(sort.Size());
  forEach([&](PointId pick) { this->Members[sort.NextPosition(surfaces[pick])] = pick; });
  this->Starts.assign(sort.Firsts(), sort.Firsts() + picks.Size() + 1);
}

//----------------------------------------------------------------------------------------------------------------------
GuidedSurface GuidedJoining::Follow(std::vector<GuideSeed> seeds) const
{
  return Follower(*this).Run(std::move(seeds));
}
}
