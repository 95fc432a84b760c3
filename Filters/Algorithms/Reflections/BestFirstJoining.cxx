// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins linked picks to surfaces, best links first (Kruskal 1956), if the parts fit: they may not overlap, and most
// facing picks must be linked. A wrong link, across a fault or onto the next layer, joins parts that face each other
// along a line with few links.
//
// A link depends on its two parts alone, so it may be tried once it is the best left of both. Threads can thus try
// links in windows of columns, with the result of one sorted list:
//
// 1. Windows are so small that their picks fit the cache.
// 2. A thread tries the links of a window. A link across the border makes its set wait, and is left for a larger
// window; so is a link to a waiting set, which makes both wait.
// 3. Windows grow, and try the links left, until one holds all columns.
// 4. There, sets that links connect, mostly those of one reflector, are independent of others: threads try the links of
// each such part. In the end refused links are tried again, as sets may have grown.

#include "SurfaceJoining.h"

#include "Common/Base/CountingSort.h"
#include "Common/Base/DisjointSets.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Base/SideBySide.h"
#include "SurfaceSets.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
struct ColumnWindow
{
  int FirstI = 0;
  int EndI = 0;
  int FirstJ = 0;
  int EndJ = 0;

  bool Has(int i, int j) const { return i >= this->FirstI && i < this->EndI && j >= this->FirstJ && j < this->EndJ; }
};

// ---- Whether two parts fit -----------------------------------------------------------------------------------------

/// Threads may work on different parts, as only the picks of two parts, and those with links to them, are read.
class PartFit
{
public:
  PartFit(
    const ReflectionPicks& picks, const ReflectionLinks& links, const JoiningRules& rules, const SurfaceSets& sets)
    : Picks(picks)
    , Links(links)
    , Rules(rules)
    , Sets(sets)
  {
  }

  /// `columns` belong to the larger set, or are null; the window must hold both sets. `shared` are picks of the smaller
  /// one in these columns.
  bool MayJoin(PointId big, const ColumnSet* columns, PointId small, const ColumnWindow& window,
    std::vector<PointId>& shared) const
  {
    const auto hasColumn = [&](int i, int j)
    { return columns ? columns->Has(i, j) : this->Sets.HasColumn(big, this->Picks.ColumnAt(i, j)); };
    const PointId size = this->Sets.SizeOf(small);
    const auto most = std::size_t(this->Rules.LargestShare * size);
    const bool needsContact = size >= this->Rules.ContactSize;
    std::int64_t facing = 0;
    std::int64_t linked = 0;
    const auto look = [&](PointId partner, int i, int j)
    {
      if (!window.Has(i, j))
      {
        return;
      }
      const bool isLinked = partner != NoPoint && this->Sets.SetOf(partner) == big;
      linked += isLinked ? 1 : 0;
      facing += isLinked || hasColumn(i, j) ? 1 : 0;
    };
    shared.clear();
    this->Sets.ForEachMember(small,
      [&](PointId pick)
      {
        const int i = this->Picks.IOf(this->Sets.ColumnOf(pick));
        const int j = this->Picks.JOf(this->Sets.ColumnOf(pick));
        if (hasColumn(i, j))
        {
          shared.push_back(pick);
        }
        for (int direction = 0; needsContact && direction < this->Links.Directions(); ++direction)
        {
          const ColumnStep& step = TraceSteps[direction];
          look(this->Links.Next(pick, direction), i + step.I, j + step.J);
          look(this->Links.Previous(pick, direction), i - step.I, j - step.J);
        }
        return shared.size() <= most;
      });
    return shared.size() <= most && (!needsContact || this->IsEnough(big, small, facing, linked));
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;

private:
  bool IsEnough(PointId big, PointId small, std::int64_t facingPairs, std::int64_t linkedPairs) const
  {
    const PointId size = this->Sets.SizeOf(small);
    const double facing = double(facingPairs);
    const double linked = double(linkedPairs);
    if (linked < this->Rules.SmallestContact * facing)
    {
      return false;
    }
    if (size < this->Rules.LargestFilled || size <= this->Rules.LargestFilledWidth * facing)
    {
      return true;
    }
    return this->Rules.Correlate && linkedPairs >= this->Rules.FewestWidePairs &&
      linked >= this->Rules.SmallestWideContact * facing &&
      this->Rules.Correlate(this->ListPairs(big, small)) >= this->Rules.SmallestWideCorrelation;
  }

  std::vector<Edge> ListPairs(PointId big, PointId small) const
  {
    std::vector<Edge> pairs;
    this->Sets.ForEachMember(small,
      [&](PointId pick)
      {
        for (int direction = 0; direction < this->Links.Directions(); ++direction)
        {
          for (const PointId partner : { this->Links.Next(pick, direction), this->Links.Previous(pick, direction) })
          {
            if (partner != NoPoint && this->Sets.SetOf(partner) == big)
            {
              pairs.push_back({ pick, partner });
            }
          }
        }
        return true;
      });
    return pairs;
  }

  const JoiningRules Rules;
  const SurfaceSets& Sets;
};

// ---- Links in the order of their ranks -----------------------------------------------------------------------------

enum class Lead
{
  Within, // both picks are in the window
  Out, // only the first pick
  In // only the second pick
};

/// Bits hold the rank, the link and its lead, from the top.
class RankedLink
{
public:
  RankedLink() = default;
  RankedLink(std::int64_t rank, LinkId link, Lead lead)
    : Bits(std::uint64_t(rank) << RankShift | std::uint64_t(link) << LeadBits | std::uint64_t(lead))
  {
    assert(rank >= 0 && rank >> 2 * DigitBits == 0);
  }

  LinkId Link() const { return LinkId(this->Bits >> LeadBits); }
  Lead Leads() const { return Lead(this->Bits & LeadMask); }
  void SetLead(Lead lead) { this->Bits = (this->Bits & ~LeadMask) | std::uint64_t(lead); }

  friend bool operator<(const RankedLink& a, const RankedLink& b) { return a.Bits < b.Bits; }

  static void SortByRank(std::vector<RankedLink>& links)
  {
    std::vector<RankedLink> sorted(links.size());
    for (const int shift : { RankShift, RankShift + DigitBits })
    {
      const auto keyOf = [shift](const RankedLink& link)
      { return std::int64_t(link.Bits >> shift & ((1U << DigitBits) - 1)); };
      SmallCountingSort<std::uint32_t, std::size_t(1) << DigitBits> sort;
      for (const RankedLink& link : links)
      {
        sort.Count(keyOf(link));
      }
      sort.EndCounting();
      for (const RankedLink& link : links)
      {
        sorted[sort.NextPosition(keyOf(link))] = link;
      }
      links.swap(sorted);
    }
  }

private:
  static constexpr int DigitBits = 8;
  static constexpr int LeadBits = 2;
  static constexpr std::uint64_t LeadMask = (1U << LeadBits) - 1;
  static constexpr int RankShift = LeadBits + 32;

  std::uint64_t Bits = 0;
};

// ---- One window ----------------------------------------------------------------------------------------------------

struct JoiningWindow : ColumnWindow
{
  bool IsFirst = true;
  std::vector<RankedLink> Left; // not tried
  std::vector<RankedLink> Refused;
  std::unordered_map<std::uint64_t, std::int64_t> Refusals; // by PairKey: size of both sets
  std::unordered_map<PointId, ColumnSet> Columns;
};

// Refused parts are tried again after this growth.
constexpr double Growth = 1.3;

// Smaller sets search their picks for columns.
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

  /// Lists the links to be tried as those left.
  void List() { this->Here.Left = std::exchange(this->Here.IsFirst, false) ? this->ListAll() : this->ListLeft(); }

  void Run(const Monitor& monitor)
  {
    std::vector<RankedLink> links = this->Here.IsFirst ? this->ListAll() : this->ListLeft();
    this->Here.IsFirst ? RankedLink::SortByRank(links) : std::sort(links.begin(), links.end());
    this->TryAll(links, monitor);
    for (const PointId set : this->Waiting)
    {
      this->Sets.SetWaits(set, false);
    }
    this->Here.IsFirst = false;
  }

  /// The window must hold all columns.
  void TryRefused(const Monitor& monitor)
  {
    std::vector<RankedLink> links = std::exchange(this->Here.Refused, {});
    this->Here.Refusals.clear();
    std::sort(links.begin(), links.end());
    this->TryAll(links, monitor);
  }

private:
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
            const ColumnStep& step = TraceSteps[direction];
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

  std::vector<RankedLink> ListLeft()
  {
    std::vector<RankedLink> links = std::exchange(this->Here.Left, {});
    std::size_t size = 0;
    for (const RankedLink& ranked : links)
    {
      const LinkId link = ranked.Link();
      const PointId from = this->Links.PickOf(link);
      const int direction = this->Links.DirectionOf(link);
      const ColumnStep& step = TraceSteps[direction];
      const std::int32_t column = this->Sets.ColumnOf(from);
      const bool isWithin = this->Here.Has(this->Picks.IOf(column) + step.I, this->Picks.JOf(column) + step.J);
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

  /// They begin just outside the border.
  void AddThoseThatLeadIn(std::vector<RankedLink>& links) const
  {
    if (this->Here.EndI - this->Here.FirstI == this->Picks.Columns[0] &&
      this->Here.EndJ - this->Here.FirstJ == this->Picks.Columns[1])
    {
      return;
    }
    const auto look = [&](PointId pick, int i, int j)
    {
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
      {
        const ColumnStep& step = TraceSteps[direction];
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

  /// Links come from all over memory. A block first reads the places it needs, so that the processor waits once.
  void TryAll(const std::vector<RankedLink>& links, const Monitor& monitor)
  {
    constexpr std::size_t block = 64;
    constexpr std::size_t blocksPerCall = 1024;
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
        // Other threads own the sets outside.
        const Lead lead = links[first + n].Leads();
        const PointId from = lead == Lead::In ? NoPoint : this->Sets.SetOf(picks[n].From);
        const PointId to = lead == Lead::Out ? NoPoint : this->Sets.SetOf(picks[n].To);
        areOne[n] = from == to;
      }
      for (std::size_t n = 0; n < size; ++n)
      {
        if (!areOne[n]) // joined sets stay joined
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

  /// Returns false if the sets were refused.
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
    if (!this->Fit.MayJoin(big, columns, small, this->Here, this->Shared))
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
    this->Sets.Absorb(big, small, this->Shared);
    return true;
  }

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
        columns.Add(this->Picks.IOf(column), this->Picks.JOf(column));
        return true;
      });
  }

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  const PartFit& Fit;
  SurfaceSets& Sets;
  JoiningWindow& Here;
  std::vector<PointId> Waiting;
  std::vector<PointId> Shared; // of the sets that are tried
};

// ---- From windows to all columns -----------------------------------------------------------------------------------

constexpr int SideGrowth = 4;

int FirstSide(const ReflectionPicks& picks, double windowPicks)
{
  const double columns = double(picks.Columns[0]) * double(picks.Columns[1]);
  const double perColumn = std::max(1.0, double(picks.Size()) / columns);
  return std::max(1, int(std::sqrt(windowPicks / perColumn)));
}

std::vector<JoiningWindow> MakeWindows(const std::array<int, 2>& columns, int side)
{
  std::vector<JoiningWindow> windows;
  for (int j = 0; j < columns[1]; j += side)
  {
    for (int i = 0; i < columns[0]; i += side)
    {
      windows.emplace_back();
      windows.back().FirstI = i;
      windows.back().EndI = std::min(i + side, columns[0]);
      windows.back().FirstJ = j;
      windows.back().EndJ = std::min(j + side, columns[1]);
    }
  }
  return windows;
}

std::vector<JoiningWindow> MergeWindows(
  const std::array<int, 2>& columns, std::vector<JoiningWindow>& windows, int side)
{
  std::vector<JoiningWindow> merged = MakeWindows(columns, side);
  const int perRow = (columns[0] + side - 1) / side;
  for (JoiningWindow& window : windows)
  {
    JoiningWindow& target = merged[window.FirstJ / side * perRow + window.FirstI / side];
    target.IsFirst = false;
    target.Left.insert(target.Left.end(), window.Left.begin(), window.Left.end());
    target.Refused.insert(target.Refused.end(), window.Refused.begin(), window.Refused.end());
    target.Refusals.merge(window.Refusals);
    target.Columns.merge(window.Columns);
    window = JoiningWindow();
  }
  return merged;
}
}

namespace
{
/// Splits what is left, and refused, of the window of all columns into parts without common sets, largest first.
class WindowParts
{
public:
  WindowParts(const ReflectionLinks& links, const SurfaceSets& sets, JoiningWindow& whole)
    : Connected(std::size_t(links.Size()))
    , Numbers(std::size_t(links.Size()), NoPoint)
  {
    const std::vector<Edge> left = ListSets(links, sets, whole.Left);
    const std::vector<Edge> refused = ListSets(links, sets, whole.Refused);
    this->Connect(left);
    this->Connect(refused);
    this->Number(left, refused, whole);
    this->Deal(left, whole.Left, &JoiningWindow::Left);
    this->Deal(refused, whole.Refused, &JoiningWindow::Refused);
    for (const auto& [key, size] : whole.Refusals)
    {
      if (JoiningWindow* const part = this->PartOf(PointId(key >> 32)))
      {
        part->Refusals.emplace(key, size);
      }
    }
    for (auto next = whole.Columns.begin(); next != whole.Columns.end();)
    {
      const auto columns = next++;
      if (JoiningWindow* const part = this->PartOf(columns->first))
      {
        part->Columns.insert(whole.Columns.extract(columns));
      }
    }
  }

  std::vector<JoiningWindow> Take() { return std::move(this->Parts); }

private:
  /// Links of dropped picks have none.
  static std::vector<Edge> ListSets(
    const ReflectionLinks& links, const SurfaceSets& sets, const std::vector<RankedLink>& ranked)
  {
    std::vector<Edge> found(ranked.size());
    ParallelFor(std::int64_t(ranked.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          const PointId from = links.PickOf(ranked[n].Link());
          const PointId to = links.Next(from, links.DirectionOf(ranked[n].Link()));
          const Edge ends = { sets.SetOf(from), sets.SetOf(to) };
          found[n] = ends.From == NoPoint || ends.To == NoPoint ? Edge{ NoPoint, NoPoint } : ends;
        }
      });
    return found;
  }

  void Connect(const std::vector<Edge>& links)
  {
    for (const Edge& sets : links)
    {
      if (sets.From != NoPoint)
      {
        this->Connected.Join(sets.From, sets.To);
      }
    }
  }

  void Number(const std::vector<Edge>& left, const std::vector<Edge>& refused, const ColumnWindow& whole)
  {
    std::vector<std::pair<std::int64_t, PointId>> sizes; // negative; representatives
    for (const std::vector<Edge>* const links : { &left, &refused })
    {
      for (const Edge& sets : *links)
      {
        if (sets.From != NoPoint)
        {
          const PointId representative = this->Connected.Find(sets.From);
          PointId& number = this->Numbers[representative];
          if (number == NoPoint)
          {
            number = PointId(sizes.size());
            sizes.emplace_back(0, representative);
          }
          --sizes[number].first;
        }
      }
    }
    std::sort(sizes.begin(), sizes.end());
    this->Parts.resize(sizes.size());
    for (std::size_t n = 0; n < sizes.size(); ++n)
    {
      this->Numbers[sizes[n].second] = PointId(n);
      static_cast<ColumnWindow&>(this->Parts[n]) = whole;
      this->Parts[n].IsFirst = false;
    }
  }

  /// Returns null for a set without links.
  JoiningWindow* PartOf(PointId set)
  {
    const PointId number = this->Numbers[this->Connected.Find(set)];
    return number == NoPoint ? nullptr : &this->Parts[number];
  }

  void Deal(
    const std::vector<Edge>& sets, const std::vector<RankedLink>& links, std::vector<RankedLink> JoiningWindow::*list)
  {
    for (std::size_t n = 0; n < links.size(); ++n)
    {
      if (sets[n].From != NoPoint)
      {
        (this->PartOf(sets[n].From)->*list).push_back(links[n]);
      }
    }
  }

  DisjointSets Connected; // by set
  std::vector<PointId> Numbers; // of parts, by representative
  std::vector<JoiningWindow> Parts;
};
}

struct BestFirstJoining::Parts
{
  explicit Parts(const ReflectionPicks& picks)
    : Sets(picks)
  {
  }

  SurfaceSets Sets;
  bool AreSingle = true;
  std::unordered_map<PointId, ColumnSet> Columns;
};

//----------------------------------------------------------------------------------------------------------------------
BestFirstJoining::BestFirstJoining(const ReflectionPicks& picks, double windowPicks)
  : Picks(picks)
  , WindowPicks(windowPicks)
  , Joined(std::make_unique<Parts>(picks))
{
}

//----------------------------------------------------------------------------------------------------------------------
BestFirstJoining::~BestFirstJoining() = default;

//----------------------------------------------------------------------------------------------------------------------
void BestFirstJoining::Run(const ReflectionLinks& links, const JoiningRules& rules, const Monitor& monitor)
{
  SurfaceSets& sets = this->Joined->Sets;
  const PartFit fit(this->Picks, links, rules, sets);
  const int all = std::max(this->Picks.Columns[0], this->Picks.Columns[1]);
  int side = std::exchange(this->Joined->AreSingle, false) ? FirstSide(this->Picks, this->WindowPicks) : all;
  std::vector<JoiningWindow> windows = MakeWindows(this->Picks.Columns, side);
  constexpr double last = 0.6;
  double done = 0.0;
  while (windows.size() > 1)
  {
    const double next = 0.5 * (done + last);
    ParallelFor(std::int64_t(windows.size()), 1, monitor.Step(done, next),
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          WindowWorker(fit, sets, windows[n]).Run(Monitor());
        }
      });
    done = next;
    side = side < all / SideGrowth ? side * SideGrowth : all;
    windows = MergeWindows(this->Picks.Columns, windows, side);
  }
  JoiningWindow& whole = windows.front();
  whole.Columns.merge(this->Joined->Columns);
  WindowWorker(fit, sets, whole).List();
  std::vector<JoiningWindow> parts = WindowParts(links, sets, whole).Take();
  RunSideBySide(std::int64_t(parts.size()), std::int64_t(parts.size()), monitor.Step(last, 1.0),
    [&](std::int64_t n, const Monitor& step)
    {
      WindowWorker worker(fit, sets, parts[n]);
      worker.Run(step.Step(0.0, 0.9));
      worker.TryRefused(step.Step(0.9, 1.0));
    });
  for (JoiningWindow& part : parts)
  {
    whole.Columns.merge(part.Columns);
  }
  this->Joined->Columns = std::move(whole.Columns);
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> BestFirstJoining::TakeSurfaces()
{
  return this->Joined->Sets.TakeLabels();
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> FindConnectedPicks(
  const ReflectionPicks& picks, ColumnConnectivity connectivity, PickDepth largestStep, const Monitor& monitor)
{
  constexpr std::int64_t band = 64;
  const int steps = int(connectivity) / 2;
  DisjointSets sets(picks.Places.size());
  const auto joinRow = [&](int j, int firstStep, int endStep)
  {
    for (int n = firstStep; n < endStep; ++n)
    {
      const ColumnStep& step = TraceSteps[n];
      for (int i = std::max(0, -step.I); i < picks.Columns[0] - std::max(0, step.I); ++i)
      {
        picks.ForEachPair(picks.ColumnAt(i, j), picks.ColumnAt(i + step.I, j + step.J), largestStep,
          [&sets](PointId a, PointId b) { sets.Join(a, b); });
      }
    }
  };
  // Threads join bands of rows, then one thread joins their seams.
  ForEachChunk(picks.Columns[1], band, monitor,
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t j = first; j < last; ++j)
      {
        joinRow(int(j), 0, j + 1 < last ? steps : 1);
      }
    });
  for (std::int64_t j = band; j < picks.Columns[1]; j += band)
  {
    joinRow(int(j - 1), 1, steps);
  }
  RawVector<PointId> components(picks.Places.size());
  for (PointId pick = 0; pick < picks.Size(); ++pick)
  {
    components[pick] = sets.Find(pick);
  }
  return components;
}
}
