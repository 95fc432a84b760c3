// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WindowJoining.h"

#include <algorithm>
#include <array>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Parts are tried again when they have grown by this.
constexpr double Growth = 1.3;

// Columns of smaller sets are looked for among the picks there.
constexpr PointId LargestSearched = 24;

std::uint64_t PairKey(PointId a, PointId b)
{
  return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
}

class WindowWorker
{
public:
  WindowWorker(const PartFit& fit, SurfaceSets& sets, JoiningWindow& window)
    : Picks(fit.Picks)
    , Links(fit.Links)
    , Fit(fit)
    , Sets(sets)
    , Here(window)
  {
  }

  void Run(const Monitor& monitor)
  {
    if (!this->Here.IsFirst)
    {
      this->Sets.SortMembers(this->Here);
    }
    std::vector<RankedLink> links = this->Here.IsFirst ? this->ListAll() : this->ListLeft();
    this->Here.IsFirst ? RankedLink::SortByRank(links) : std::sort(links.begin(), links.end());
    this->TryAll(links, monitor);
    for (const PointId set : this->Waiting)
    {
      this->Sets.SetWaits(set, false);
    }
    this->Here.IsFirst = false;
  }

  /// In a window of all columns.
  void TryRefused(const Monitor& monitor)
  {
    std::vector<RankedLink> links = std::exchange(this->Here.Refused, {});
    this->Here.Refusals.clear();
    std::sort(links.begin(), links.end());
    this->TryAll(links, monitor);
  }

private:
  /// Calls visit(pick, i, j) for the picks of some columns of a row.
  template <typename Visit>
  void ForEachPick(int j, int firstI, int endI, Visit&& visit) const
  {
    for (int i = firstI; i < endI; ++i)
    {
      const std::int64_t column = this->Picks.ColumnAt(i, j);
      for (PointId pick = this->Picks.Begin(column); pick < this->Picks.End(column); ++pick)
      {
        visit(pick, i, j);
      }
    }
  }

  std::vector<RankedLink> ListAll() const
  {
    std::vector<RankedLink> links;
    this->AddThoseThatLeadIn(links);
    for (int j = this->Here.FirstJ; j < this->Here.EndJ; ++j)
    {
      this->ForEachPick(j, this->Here.FirstI, this->Here.EndI,
        [&](PointId pick, int i, int)
        {
          for (int direction = 0; direction < this->Links.Directions(); ++direction)
          {
            const PointId next = this->Links.Next(pick, direction);
            const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
            const bool isWithin = this->Here.Has(i + step.I, j + step.J);
            if (next != NoPoint && !(isWithin && this->Sets.SetOf(pick) == this->Sets.SetOf(next)))
            {
              this->Add(links, pick, direction, isWithin ? Lead::Within : Lead::Out);
            }
          }
        });
    }
    return links;
  }

  /// Those that other windows left.
  std::vector<RankedLink> ListLeft()
  {
    std::vector<RankedLink> links = std::exchange(this->Here.Left, {});
    std::size_t size = 0;
    const int width = this->Picks.Columns[0];
    for (const RankedLink& ranked : links)
    {
      const LinkId link = ranked.Link();
      const PointId from = this->Links.PickOf(link);
      const int direction = this->Links.DirectionOf(link);
      const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
      const std::int32_t column = this->Sets.ColumnOf(from);
      const bool isWithin = this->Here.Has(column % width + step.I, column / width + step.J);
      const PointId set = this->Sets.SetOf(from);
      const PointId other = isWithin ? this->Sets.SetOf(this->Links.Next(from, direction)) : NoPoint;
      if (set != NoPoint && set != other && (!isWithin || other != NoPoint))
      {
        links[size] = ranked;
        links[size++].SetLead(isWithin ? Lead::Within : Lead::Out);
      }
    }
    links.resize(size);
    this->AddThoseThatLeadIn(links);
    return links;
  }

  /// They begin in columns outside, beside those of the rim.
  void AddThoseThatLeadIn(std::vector<RankedLink>& links) const
  {
    const auto look = [&](PointId pick, int i, int j)
    {
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
      {
        const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
        const PointId previous = this->Links.Previous(pick, direction);
        if (previous != NoPoint && !this->Here.Has(i - step.I, j - step.J) && this->Sets.SetOf(pick) != NoPoint)
        {
          this->Add(links, previous, direction, Lead::In);
        }
      }
    };
    for (int j = this->Here.FirstJ; j < this->Here.EndJ; ++j)
    {
      if (j == this->Here.FirstJ)
      {
        this->ForEachPick(j, this->Here.FirstI, this->Here.EndI, look);
        continue;
      }
      this->ForEachPick(j, this->Here.FirstI, this->Here.FirstI + 1, look);
      if (this->Here.EndI - this->Here.FirstI > 1)
      {
        this->ForEachPick(j, this->Here.EndI - 1, this->Here.EndI, look);
      }
    }
  }

  void Add(std::vector<RankedLink>& links, PointId pick, int direction, Lead lead) const
  {
    links.emplace_back(this->Links.Rank(pick, direction), this->Links.MakeId(pick, direction), lead);
  }

  /// Links come from all over memory. In blocks, the places they need are read side by side first, so that the
  /// processor waits for them once.
  void TryAll(const std::vector<RankedLink>& links, const Monitor& monitor)
  {
    constexpr std::size_t block = 64;
    constexpr std::size_t blocksPerCall = 1024; // of the monitor
    std::array<Edge, block> picks;
    std::array<bool, block> areOne;
    for (std::size_t first = 0; first < links.size(); first += block)
    {
      if (first % (block * blocksPerCall) == 0)
      {
        monitor.Progress(double(first) / double(links.size()));
      }
      const std::size_t size = std::min(block, links.size() - first);
      for (std::size_t n = 0; n < size; ++n)
      {
        const LinkId link = links[first + n].Link();
        const PointId from = this->Links.PickOf(link);
        picks[n] = { from, this->Links.Next(from, this->Links.DirectionOf(link)) };
      }
      for (std::size_t n = 0; n < size; ++n)
      {
        // Sets outside are those of other threads.
        const Lead lead = links[first + n].Leads();
        const PointId from = lead == Lead::In ? NoPoint : this->Sets.SetOf(picks[n].From);
        const PointId to = lead == Lead::Out ? NoPoint : this->Sets.SetOf(picks[n].To);
        areOne[n] = from == to;
      }
      for (std::size_t n = 0; n < size; ++n)
      {
        if (!areOne[n]) // sets that are one stay one
        {
          this->Look(links[first + n], picks[n]);
        }
      }
    }
  }

  void Look(const RankedLink& link, const Edge& picks)
  {
    switch (link.Leads())
    {
      case Lead::Within:
        this->TryWithin(link, this->Sets.SetOf(picks.From), this->Sets.SetOf(picks.To));
        break;
      case Lead::Out:
        this->Wait(this->Sets.SetOf(picks.From));
        this->Here.Left.push_back(link);
        break;
      case Lead::In:
        this->Wait(this->Sets.SetOf(picks.To));
        break;
    }
  }

  void TryWithin(RankedLink link, PointId a, PointId b)
  {
    if (a == b || a == NoPoint || b == NoPoint)
    {
      return;
    }
    if (this->Sets.Waits(a) || this->Sets.Waits(b))
    {
      this->Wait(a);
      this->Wait(b);
      this->Here.Left.push_back(link);
    }
    else if (!this->Try(a, b))
    {
      this->Here.Refused.push_back(link);
    }
  }

  void Wait(PointId set)
  {
    if (set != NoPoint && !this->Sets.Waits(set))
    {
      this->Sets.SetWaits(set, true);
      this->Waiting.push_back(set);
    }
  }

  /// False when the sets were refused.
  bool Try(PointId big, PointId small)
  {
    if (this->Sets.SizeOf(big) < this->Sets.SizeOf(small))
    {
      std::swap(big, small);
    }
    const std::uint64_t key = PairKey(big, small);
    const std::int64_t size = std::int64_t(this->Sets.SizeOf(big)) + this->Sets.SizeOf(small);
    const auto found = this->Here.Refusals.find(key);
    if (found != this->Here.Refusals.end() && double(size) < Growth * double(found->second))
    {
      return false;
    }
    ColumnSet* const columns = this->ColumnsOf(big);
    std::int64_t shared = 0;
    if (!this->Fit.MayJoin(big, columns, small, this->Here, shared))
    {
      this->Here.Refusals[key] = size;
      return false;
    }
    if (columns)
    {
      this->AddColumns(*columns, small);
    }
    if (this->Sets.SizeOf(small) >= LargestSearched)
    {
      this->Here.Columns.erase(small);
    }
    this->Sets.Absorb(big, small, shared > 0);
    return true;
  }

  /// The columns of a large set, or null.
  ColumnSet* ColumnsOf(PointId set)
  {
    if (this->Sets.SizeOf(set) < LargestSearched)
    {
      return nullptr;
    }
    const auto [found, isNew] = this->Here.Columns.try_emplace(set);
    if (isNew)
    {
      this->AddColumns(found->second, set);
    }
    return &found->second;
  }

  void AddColumns(ColumnSet& columns, PointId set) const
  {
    this->Sets.ForEachMember(set,
      [&](PointId pick)
      {
        const std::int32_t column = this->Sets.ColumnOf(pick);
        columns.Add(column % this->Picks.Columns[0], column / this->Picks.Columns[0]);
        return true;
      });
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  const PartFit& Fit;
  SurfaceSets& Sets;
  JoiningWindow& Here;
  std::vector<PointId> Waiting;
};
}

//----------------------------------------------------------------------------------------------------------------------
void JoinWindow(const PartFit& fit, SurfaceSets& sets, JoiningWindow& window, const Monitor& monitor)
{
  WindowWorker(fit, sets, window).Run(monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void JoinRefused(const PartFit& fit, SurfaceSets& sets, JoiningWindow& window, const Monitor& monitor)
{
  WindowWorker(fit, sets, window).TryRefused(monitor);
}
}
