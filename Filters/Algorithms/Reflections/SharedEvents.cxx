// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// 1. Guides compete for a shared pick from their other picks, and their given ones. The way with the strongest weakest
// link wins, as growth leaks over weak links. Equal ways both win.
// 2. Near its other picks a guide keeps what it shares, as horizons converge before they meet.
// 3. Where several guides have given picks on an event, they all keep it.

#include "SharedEvents.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <queue>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int ConvergingColumns = 8;
constexpr double SmallestSpreading = 0.7; // score of links
constexpr float Unreached = -2.0F; // less than any score

class SharedEvents
{
public:
  SharedEvents(const ReflectionPicks& picks, const GrowthLinks& links, const std::vector<GuidedSurface*>& surfaces)
    : Picks(picks)
    , Links(links)
    , Surfaces(surfaces)
    , Firsts(picks.Size(), 0)
  {
    this->ForEachPick([this](const GuidedPick& pick, std::int32_t) { ++this->Firsts[pick.Pick]; });
    this->ForEachPick(
      [this](const GuidedPick& pick, std::int32_t guide)
      {
        if (this->Firsts[pick.Pick] > 1)
        {
          this->Owners.push_back({ pick.Pick, guide });
        }
      });
    std::sort(this->Owners.begin(), this->Owners.end(),
      [](const Owner& a, const Owner& b) { return std::pair(a.Pick, a.Guide) < std::pair(b.Pick, b.Guide); });
    std::fill(this->Firsts.begin(), this->Firsts.end(), NoOwner);
    for (std::size_t n = this->Owners.size(); n-- > 0;)
    {
      this->Firsts[this->Owners[n].Pick] = std::int32_t(n);
    }
  }

  SharedCounts Settle()
  {
    if (this->Owners.empty())
    {
      return {};
    }
    std::vector<Place> own;
    std::vector<Place> given;
    this->ForEachPick(
      [&](const GuidedPick& pick, std::int32_t guide)
      {
        const bool isShared = this->Firsts[pick.Pick] != NoOwner;
        const bool isGiven = pick.Origin == PickOrigin::Guide;
        if (!isShared || isGiven)
        {
          own.push_back({ pick.Pick, guide });
        }
        if (isShared && isGiven)
        {
          given.push_back({ pick.Pick, guide });
        }
      });
    this->Compete(own);
    this->Spread(own, ConvergingColumns, &Owner::IsNear);
    this->Spread(std::move(given), std::numeric_limits<int>::max(), &Owner::IsOnGiven);
    for (std::size_t n = 0; n < this->Surfaces.size(); ++n)
    {
      std::vector<GuidedPick>& kept = this->Surfaces[n]->Picks;
      const auto isLost = [&](const GuidedPick& pick)
      {
        const Owner* const owner = this->FindOwner({ pick.Pick, std::int32_t(n) });
        return owner && !this->IsKept(*owner);
      };
      kept.erase(std::remove_if(kept.begin(), kept.end(), isLost), kept.end());
    }
    return this->CountShared();
  }

private:
  static constexpr std::int32_t NoOwner = -1;

  struct Place
  {
    PointId Pick = NoPoint;
    std::int32_t Guide = 0;
  };

  /// A guide that has a shared pick.
  struct Owner : Place
  {
    float Weakest = Unreached; // link of the way
    bool IsNear = false;
    bool IsOnGiven = false;
  };

  struct Claim
  {
    float Weakest = 0.0F;
    Owner* Claimant = nullptr;

    /// std::priority_queue returns the largest first.
    friend bool operator<(const Claim& a, const Claim& b) { return a.Weakest < b.Weakest; }
  };

  template <typename Visit>
  void ForEachPick(Visit&& visit) const
  {
    for (std::size_t n = 0; n < this->Surfaces.size(); ++n)
    {
      for (const GuidedPick& pick : this->Surfaces[n]->Picks)
      {
        visit(pick, std::int32_t(n));
      }
    }
  }

  template <typename Visit>
  void ForEachOwner(PointId pick, Visit&& visit)
  {
    const std::int32_t first = this->Firsts[pick];
    for (std::size_t n = first; first != NoOwner && n < this->Owners.size() && this->Owners[n].Pick == pick; ++n)
    {
      visit(this->Owners[n]);
    }
  }

  /// Returns a null pointer unless the guide shares the pick.
  Owner* FindOwner(const Place& place)
  {
    Owner* found = nullptr;
    this->ForEachOwner(place.Pick, [&](Owner& owner) { found = owner.Guide == place.Guide ? &owner : found; });
    return found;
  }

  float StrongestOf(PointId pick)
  {
    float strongest = Unreached;
    this->ForEachOwner(pick, [&](const Owner& owner) { strongest = std::max(strongest, owner.Weakest); });
    return strongest;
  }

  /// Visits the linked picks that the guide shares.
  template <typename Visit>
  void ForEachLinked(const Place& place, Visit&& visit)
  {
    this->Links.ForEachOf(place.Pick,
      [&](PointId to, double correlation)
      {
        if (Owner* const owner = this->FindOwner({ to, place.Guide }))
        {
          visit(*owner, LinkScore(correlation, std::abs(this->Picks.Places[to] - this->Picks.Places[place.Pick])));
        }
      });
  }

  void Compete(const std::vector<Place>& starts)
  {
    std::priority_queue<Claim> rim;
    const auto addRim = [&](const Place& from, float weakest)
    {
      this->ForEachLinked(from,
        [&](Owner& owner, double score)
        {
          if (owner.Weakest == Unreached)
          {
            rim.push({ std::min(weakest, float(score)), &owner });
          }
        });
    };
    for (const Place& start : starts)
    {
      if (Owner* const owner = this->FindOwner(start))
      {
        owner->Weakest = 1.0F;
      }
    }
    for (const Place& start : starts)
    {
      addRim(start, 1.0F);
    }
    while (!rim.empty())
    {
      const Claim claim = rim.top();
      rim.pop();
      Owner& owner = *claim.Claimant;
      if (owner.Weakest == Unreached && this->StrongestOf(owner.Pick) <= claim.Weakest)
      {
        owner.Weakest = claim.Weakest;
        addRim(owner, claim.Weakest);
      }
    }
  }

  /// Marks shared picks within some columns.
  void Spread(std::vector<Place> front, int columns, bool Owner::*mark)
  {
    for (const Place& place : front)
    {
      if (Owner* const owner = this->FindOwner(place))
      {
        owner->*mark = true;
      }
    }
    for (int n = 0; n < columns && !front.empty(); ++n)
    {
      std::vector<Place> reached;
      for (const Place& place : front)
      {
        this->ForEachLinked(place,
          [&](Owner& owner, double score)
          {
            if (score >= SmallestSpreading && !(owner.*mark))
            {
              owner.*mark = true;
              reached.push_back(owner);
            }
          });
      }
      front = std::move(reached);
    }
  }

  bool IsKept(const Owner& owner)
  {
    int onGiven = 0;
    this->ForEachOwner(owner.Pick, [&](const Owner& one) { onGiven += one.IsOnGiven ? 1 : 0; });
    return owner.Weakest == this->StrongestOf(owner.Pick) || owner.IsNear || (owner.IsOnGiven && onGiven > 1);
  }

  SharedCounts CountShared()
  {
    SharedCounts counts;
    for (const Owner& owner : this->Owners)
    {
      this->ForEachOwner(owner.Pick,
        [&](const Owner& other)
        {
          if (other.Guide > owner.Guide && this->IsKept(owner) && this->IsKept(other))
          {
            ++counts[{ std::size_t(owner.Guide), std::size_t(other.Guide) }];
          }
        });
    }
    return counts;
  }

  const ReflectionPicks& Picks;
  const GrowthLinks& Links;
  const std::vector<GuidedSurface*>& Surfaces;
  RawVector<std::int32_t> Firsts; // by pick, into Owners
  std::vector<Owner> Owners; // by pick and guide
};
}

//----------------------------------------------------------------------------------------------------------------------
SharedCounts SettleSharedEvents(
  const ReflectionPicks& picks, const GrowthLinks& links, const std::vector<GuidedSurface*>& surfaces)
{
  return SharedEvents(picks, links, surfaces).Settle();
}
}
