// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Parts of surfaces with picks of the guide are taken. If a part passes more picks elsewhere than it has, its picks
// are strays, which steer no parts; if few, it ran into another event and is cut half-way.
// 2. The surface grows from all its picks at once, best link first (Prim 1957), into free columns. Parts growing from
// both sides stop each other.
// 3. Parts that growth runs along are taken whole, as they are more reliable, and the surface grows anew.
// 4. Parts lose where plain growth from all picks, strays too, is better (GrowthVote.h), as a part may run into another
// event, and a stray may be the one good pick behind a fault.

#include "GuidedJoining.h"

#include "Common/Base/CountingSort.h"
#include "GrowthVote.h"
#include "GuideConfidence.h"
#include "GuideLikeness.h"
#include "PlainGrowth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
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

// Farther out, in columns, growth from the picks alone is better.
constexpr int FarthestFromParts = 60;

// Later rounds find no parts worth taking.
constexpr int Rounds = 2;
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
    this->Given = std::move(seeds);
    this->MeasureDistances();
    this->PlaceSeeds(this->Given);
    const GrownPicks plain = this->GrowFromSeeds();
    this->SetStraysAside(result.Strays);
    this->PlaceSeeds(this->Seeds);
    for (const PointId part : ListParts(this->CountVotes(), [](const Votes& vote) { return vote.Hits >= vote.Misses; }))
    {
      this->TakePart(part, LargestSeededConflict);
    }
    this->GrowAround();
    for (int round = 0; round < Rounds && this->TakeGrownParts(); ++round)
    {
      this->GrowAround();
    }
    this->Vote(plain.Picks);
    this->Write(result);
    result.Stopped = std::count_if(plain.Stops.begin(), plain.Stops.end(),
      [this](std::int32_t column) { return this->Kept[column].Pick == NoPoint; });
    return result;
  }

private:
  PointId PartOf(PointId pick) const
  {
    const PointId part = this->Joining.Surfaces[pick];
    return part != NoPoint && this->SizeOf(part) >= SmallestPart ? part : NoPoint;
  }
  PointId SizeOf(PointId part) const
  {
    return this->Joining.Members.Starts[part + 1] - this->Joining.Members.Starts[part];
  }

  template <typename Visit>
  void ForEachMember(PointId part, Visit&& visit) const
  {
    for (PointId n = this->Joining.Members.Starts[part]; n < this->Joining.Members.Starts[part + 1]; ++n)
    {
      visit(this->Joining.Members.Picks[n]);
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

  void PlaceSeeds(const std::vector<GuideSeed>& seeds)
  {
    std::fill(this->Found.begin(), this->Found.end(), NoPoint);
    for (const GuideSeed& seed : seeds)
    {
      this->Found[seed.Column] = seed.Pick;
    }
  }

  /// Unless each pick contradicts the others.
  void SetStraysAside(std::vector<std::size_t>& strays)
  {
    this->Seeds = this->Given;
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
    if (strays.size() < this->Seeds.size())
    {
      this->Seeds.erase(std::remove_if(this->Seeds.begin(), this->Seeds.end(), isStray), this->Seeds.end());
    }
  }

  /// Distances take two passes, over the columns before and after.
  void MeasureDistances()
  {
    const auto [columns, rows] = this->Picks.Columns;
    this->Distances.assign(this->Found.size(), columns + rows);
    for (const GuideSeed& seed : this->Given)
    {
      this->Distances[seed.Column] = 0;
    }
    for (const int sign : { -1, 1 })
    {
      for (std::size_t n = 0; n < this->Distances.size(); ++n)
      {
        const auto column = std::int32_t(sign < 0 ? n : this->Distances.size() - 1 - n);
        this->ForEachBeside(column,
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
      const PointId found = this->Found[this->Joining.Members.Columns[member]];
      conflicts += found != NoPoint && !this->AreSameEvent(found, member) ? 1 : 0;
      news += found == NoPoint ? 1 : 0;
    }
    if (double(conflicts) > largestConflict * double(members.size()) || news == 0)
    {
      return false;
    }
    for (const PointId member : members)
    {
      PointId& found = this->Found[this->Joining.Members.Columns[member]];
      found = found == NoPoint ? member : found;
    }
    return true;
  }

  /// If the part passes seeds elsewhere, picks nearer to these are left out.
  std::vector<PointId> MembersBesideMisses(PointId part) const
  {
    std::vector<PointId> members;
    const std::vector<PointId> misses = this->MissesOf(part);
    enum : unsigned char
    {
      Unknown,
      Near, // to the surface
      Far
    };
    std::vector<unsigned char> sides(this->Found.size(), Unknown); // by column
    std::vector<std::int32_t> front;
    this->ForEachMember(part,
      [&](PointId member)
      {
        members.push_back(member);
        const std::int32_t column = this->Joining.Members.Columns[member];
        if (!misses.empty() && (this->Found[column] == member || this->Grown[column] == member))
        {
          front.push_back(column);
          sides[column] = Near;
        }
      });
    if (misses.empty())
    {
      return members;
    }
    for (const PointId miss : misses)
    {
      front.push_back(this->Joining.Members.Columns[miss]);
      sides[front.back()] = Far;
    }
    for (std::size_t n = 0; n < front.size(); ++n) // breadth first
    {
      const unsigned char side = sides[front[n]];
      this->ForEachBeside(front[n],
        [&](std::int64_t column)
        {
          if (sides[column] == Unknown && this->MemberIn(part, column) != NoPoint)
          {
            sides[column] = side;
            front.push_back(std::int32_t(column));
          }
        });
    }
    members.erase(std::remove_if(members.begin(), members.end(),
                    [&](PointId member) { return sides[this->Joining.Members.Columns[member]] != Near; }),
      members.end());
    return members;
  }

  template <typename Visit>
  void ForEachBeside(std::int32_t column, Visit&& visit) const
  {
    ForEachNeighbour(this->Picks, column, ColumnConnectivity::Eight, visit);
  }

  GrownPicks GrowFromSeeds() const
  {
    GrowthRules rules{ this->Joining.Options.GrowthCorrelation, this->Joining.Options.GrowthReach };
    rules.Distances = &this->Distances;
    return GrowPlainly(this->Picks, this->Joining.Members.Columns, this->Joining.Links, this->Found, rules);
  }

  void GrowAround()
  {
    GrowthRules rules{ this->Joining.Options.GrowthCorrelation };
    rules.Reach = std::min(this->Joining.Options.GrowthReach, FarthestFromParts);
    rules.IsCareful = true;
    this->Grown =
      GrowPlainly(this->Picks, this->Joining.Members.Columns, this->Joining.Links, this->Found, rules).Picks;
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

  /// Parts lose where growth from the given picks alone is better. Around a stray what it contradicts is not compared with
  /// it.
  void Vote(const std::vector<PointId>& plain)
  {
    std::vector<Candidates> columns(this->Found.size());
    for (std::size_t column = 0; column < columns.size(); ++column)
    {
      const PointId found = this->Found[column];
      columns[column][0].Pick = found != NoPoint ? found : this->Grown[column];
      columns[column][0].IsPart = found != NoPoint;
      columns[column][1].Pick = plain[column];
    }
    for (const GuideSeed& seed : this->Given)
    {
      columns[seed.Column][1].Pick = seed.Pick;
      columns[seed.Column][1].IsGiven = true;
    }
    for (const GuideSeed& seed : this->Seeds)
    {
      columns[seed.Column][0].IsGiven = true;
    }
    if (this->Seeds.size() == this->Given.size())
    {
      this->Compare({ VoteSide::Parts, VoteSide::Growth }, this->Given, columns);
    }
    else
    {
      this->Compare({ VoteSide::Parts }, this->Seeds, columns);
      this->Compare({ VoteSide::Growth }, this->Given, columns);
    }
    const std::vector<VoteSide> sides = VoteByRegions(this->Picks, columns, this->Joining.Quarter);
    this->Kept.resize(columns.size());
    for (std::size_t column = 0; column < columns.size(); ++column)
    {
      if (sides[column] != VoteSide::None)
      {
        this->Kept[column] = columns[column][int(sides[column])];
      }
    }
  }

  void Compare(
    const std::vector<VoteSide>& sides, const std::vector<GuideSeed>& seeds, std::vector<Candidates>& columns) const
  {
    std::vector<PointId> given(seeds.size());
    std::transform(seeds.begin(), seeds.end(), given.begin(), [](const GuideSeed& seed) { return seed.Pick; });
    CompareWithGiven(this->Joining.Cube, this->Picks, given, this->Joining.HalfWidth, sides, columns);
  }

  void Write(GuidedSurface& result) const
  {
    const std::vector<float> confidence = MeasureConfidence(this->Picks, this->Kept, this->Joining.Quarter);
    std::vector<PointId> surface(this->Kept.size(), NoPoint);
    auto seed = this->Given.begin();
    for (std::size_t column = 0; column < this->Kept.size(); ++column)
    {
      const Candidate& kept = this->Kept[column];
      const bool isSeed = seed != this->Given.end() && std::size_t(seed->Column) == column;
      if (isSeed)
      {
        result.Picks.push_back({ kept.Pick, PickOrigin::Guide });
        result.Picks.back().Seed = std::int32_t(seed->Number);
        ++seed;
      }
      else if (kept.Pick != NoPoint && double(confidence[column]) < this->Joining.Options.LeastConfidence)
      {
        ++result.Doubtful;
        continue;
      }
      else if (kept.Pick != NoPoint)
      {
        const PickOrigin origin = kept.IsPart ? PickOrigin::Part : PickOrigin::Growth;
        result.Picks.push_back({ kept.Pick, origin, this->Distances[column], confidence[column], kept.Likeness });
      }
      surface[column] = kept.Pick;
    }
    result.Seams = CountSeams(this->Joining.Cube, this->Picks, surface, this->Joining.Quarter);
  }

  const GuidedJoining& Joining;
  const ReflectionPicks& Picks;
  std::vector<GuideSeed> Given; // by column
  std::vector<GuideSeed> Seeds; // of them those that are no strays
  std::vector<PointId> Found; // by column: seeds and parts
  std::vector<PointId> Grown;
  std::vector<Candidate> Kept; // by column
  std::vector<int> Distances;
};

//----------------------------------------------------------------------------------------------------------------------
SurfaceMembers::SurfaceMembers(const ReflectionPicks& picks, const RawVector<PointId>& surfaces)
  : Columns(picks.ListColumns())
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
  this->Picks.resize(sort.Size());
  forEach([&](PointId pick) { this->Picks[sort.NextPosition(surfaces[pick])] = pick; });
  this->Starts.assign(sort.Firsts(), sort.Firsts() + picks.Size() + 1);
}

//----------------------------------------------------------------------------------------------------------------------
GuidedJoining::GuidedJoining(const TraceCube& cube, const ReflectionPicks& picks, const RawVector<PointId>& surfaces,
  const SurfaceMembers& members, const GrowthLinks& links, int halfWidth, double period, const GuidanceOptions& options)
  : Cube(cube)
  , Picks(picks)
  , Surfaces(surfaces)
  , Members(members)
  , Links(links)
  , HalfWidth(halfWidth)
  , Options(options)
  , Quarter(PickDepth(std::lround(period / 4.0 * DepthsPerSample)))
{
}

//----------------------------------------------------------------------------------------------------------------------
GuidedSurface GuidedJoining::Follow(std::vector<GuideSeed> seeds) const
{
  return Follower(*this).Run(std::move(seeds));
}
}
