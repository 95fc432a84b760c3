// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: candidates, long hops that no point near their start rules out; the border, points beside empty
// columns, which alone have long hops; admissible hops, direct hops first, then the rest from short to long; the list
// of hops by point; blocks with cuts.

#include "PlanarHops.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NoLink = -1;

constexpr std::size_t HopsPerBatch = 4096;
}

// A hop is not admissible (PlanarHops.h) if it passes over a point or between two neighbouring points. The points of a
// row are bits of one number. Each point or pair of points near the start rules out hops to its shadow:
//
//       . . # # # # .        *    start of hops
//       . . # # # . .        a, b two neighbouring points
//       . . a b . . .        #    their shadow, behind a, b or the line between them
//       . . * . . . .
class HopCandidates
{
public:
  /// The index needs an empty rim of at least k columns. `points` may add places to its points.
  HopCandidates(const ColumnIndex& index, const PlaceSet& points, const HopVectors& hops, const LongHops& longHops)
    : Index(index)
    , Points(points)
    , Long(longHops)
    , Radius(hops.Radius())
    , Ends()
    , OpenNumbers(std::size_t(1) << NearestBits, -1)
    , Shadows(Slot(Kinds, -NearRadius, 0), this->Ends)
  {
    for (std::size_t number = 0; number < longHops.Size(); ++number)
    {
      const PlanePoint& end = hops.Vector(longHops[number].Hop);
      this->Ends[end.Y] |= Window(1) << (end.X + this->Radius);
      for (const Gate& gate : longHops[number].Gates)
      {
        this->AddToShadow(gate.Step, gate.Column, end);
      }
      for (const PlanePoint& column : longHops[number].ColumnsOver)
      {
        this->AddToShadow(Itself, column, end);
      }
    }
  }

  /// Calls visit(number in LongHops), row by row, for hops to points that no point within NearRadius rules out.
  template <typename Visitor>
  void ForEach(std::int64_t from, Visitor&& visit) const
  {
    Rows ends;
    this->FindEndsBeyondNearest(from, ends);
    if (this->Count(ends) > FewEnds)
    {
      this->RuleOut(this->NearRowsAt(from, NearRadius), ends);
    }
    for (std::int32_t row = 0; row <= this->Radius; ++row)
    {
      for (Window left = ends[row]; left != 0; left &= left - 1)
      {
        visit(this->Long.NumberOf({ FirstColumn(left) - this->Radius, row }));
      }
    }
  }

  bool IsFree(std::int64_t place, const LongHop& hop) const
  {
    const auto has = [this, place](std::int64_t offset) { return this->Index.Has(place + offset); };
    return std::none_of(hop.Gates.begin(), hop.Gates.end(),
             [&has](const Gate& gate) { return has(gate.Offset) && has(gate.OtherOffset); }) &&
      std::none_of(hop.Over.begin(), hop.Over.end(), has);
  }

private:
  static constexpr std::int32_t NearRadius = 3;
  static constexpr std::int32_t NearWidth = 2 * NearRadius + 1;
  static constexpr std::int32_t NearestRadius = 2;
  static constexpr int NearestBits = (NearestRadius + 1) * (2 * NearestRadius + 1);
  // Fewer ends are tested faster than farther points could rule them out.
  static constexpr int FewEnds = 8;

  using NearRows = std::array<unsigned, NearRadius + 2>; // with an empty row above
  // A hop is ruled out by a point and its neighbour after one of NeighbourSteps, or by a point alone.
  static constexpr std::size_t Itself = NeighbourSteps.size();
  static constexpr std::size_t Kinds = Itself + 1;

  using Window = PlaceSet::Window;
  static constexpr std::size_t MostRows = LargestRadius + 1;
  using Rows = std::array<Window, MostRows>;

  static std::int32_t FirstColumn(Window window)
  {
    const auto low = static_cast<std::uint64_t>(window);
    return low != 0 ? LowestBit(low) : PlaceSet::WordBits + LowestBit(std::uint64_t(window >> PlaceSet::WordBits));
  }

  static std::size_t Slot(std::size_t kind, std::int32_t x, std::int32_t y)
  {
    return (kind * (NearRadius + 1) + std::size_t(y)) * NearWidth + std::size_t(x + NearRadius);
  }

  NearRows NearRowsAt(std::int64_t from, std::int32_t radius) const
  {
    const unsigned columns = ((1U << (2 * radius + 1)) - 1) << (NearRadius - radius);
    NearRows near = {};
    for (std::int32_t row = 0; row <= radius; ++row)
    {
      near[row] = unsigned(this->Points.From(from + row * this->Index.Width() - NearRadius)) & columns;
    }
    return near;
  }

  void RuleOut(const NearRows& near, Rows& ends) const
  {
    for (std::int32_t row = 0; row <= NearRadius; ++row)
    {
      const unsigned here = near[row];
      const unsigned above = near[std::size_t(row) + 1];
      // The order follows NeighbourSteps.
      const std::array<unsigned, Kinds> found = { here & here >> 1U, here & above >> 1U, here & above,
        here & above << 1U, here };
      for (std::size_t kind = 0; kind < Kinds; ++kind)
      {
        for (unsigned columns = found[kind]; columns != 0; columns &= columns - 1)
        {
          const Rows& shadow = this->Shadows[Slot(kind, LowestBit(columns) - NearRadius, row)];
          for (std::size_t n = std::size_t(row); n <= std::size_t(this->Radius); ++n)
          {
            ends[n] &= ~shadow[n];
          }
        }
      }
    }
  }

  /// This is a table look-up, unless the pattern of the nearest points is new.
  void FindEndsBeyondNearest(std::int64_t from, Rows& ends) const
  {
    const NearRows near = this->NearRowsAt(from, NearestRadius);
    unsigned bits = 0;
    for (std::int32_t row = NearestRadius; row >= 0; --row)
    {
      bits = bits << (2 * NearestRadius + 1) | near[row] >> (NearRadius - NearestRadius);
    }
    std::int32_t& number = this->OpenNumbers[bits];
    if (number < 0)
    {
      number = std::int32_t(this->OpenByNearest.size());
      this->OpenByNearest.push_back(this->Ends);
      this->RuleOut(near, this->OpenByNearest.back());
    }
    const Rows& open = this->OpenByNearest[number];
    for (std::int32_t row = 0; row <= this->Radius; ++row)
    {
      const Window left = open[row];
      ends[row] = left == 0 ? left : left & this->Points.From(from + row * this->Index.Width() - this->Radius);
    }
  }

  int Count(const Rows& rows) const
  {
    int count = 0;
    for (std::size_t row = 0; row <= std::size_t(this->Radius); ++row)
    {
      count += CountBits(std::uint64_t(rows[row])) + CountBits(std::uint64_t(rows[row] >> 64));
    }
    return count;
  }

  void AddToShadow(std::size_t kind, const PlanePoint& column, const PlanePoint& end)
  {
    const PlanePoint step = kind == Itself ? PlanePoint{} : NeighbourSteps[kind];
    const PlanePoint other{ column.X + step.X, column.Y + step.Y };
    if (ChebyshevLength(column) <= NearRadius && ChebyshevLength(other) <= NearRadius && column.Y >= 0)
    {
      this->Shadows[Slot(kind, column.X, column.Y)][end.Y] |= Window(1) << (end.X + this->Radius);
    }
  }

  const ColumnIndex& Index;
  const PlaceSet& Points;
  const LongHops& Long;
  const std::int32_t Radius;
  Rows Ends;
  mutable std::vector<Rows> OpenByNearest; // by pattern of the nearest points
  mutable std::vector<std::int32_t> OpenNumbers; // position there by pattern, or -1
  std::vector<Rows> Shadows; // Each slot holds the ends that a point or pair of points rules out.
};

//----------------------------------------------------------------------------------------------------------------------
PlanarHops::PlanarHops(const ColumnIndex& index, const HopVectors& hops, const CutBlocks* cuts, const Monitor& monitor)
  : Index(index)
  , Hops(hops)
  , Cuts(cuts)
  , Long(hops)
  , South(hops.Radius() > 1 ? hops.Find({ 0, -2 }) : NoHop)
  , North(hops.Radius() > 1 ? hops.Find({ 0, 2 }) : NoHop)
{
  const PlaceSet filled = this->FindBorder();
  this->First.assign(std::size_t(index.Width() * index.Height()), NoLink);
  const HopCandidates candidates(index, filled, hops, this->Long);
  this->AddDirectHops(candidates, monitor.Step(0.0, 0.4));
  std::vector<PlacedHop> across = this->AddFurtherHops(candidates, monitor.Step(0.4, 0.9));
  const std::size_t admissible = this->Placed.size();
  this->AddUncrossed(across, monitor.Step(0.9, 1.0));
  std::vector<std::int32_t>().swap(this->First);
  std::vector<Link>().swap(this->Links);
  this->Listed = this->ListByPoint(admissible);
  this->Across = this->ListAcross(admissible);
  std::vector<PlacedHop>().swap(this->Placed);
}

//----------------------------------------------------------------------------------------------------------------------
// A single empty column counts as a point when long hops are searched for, as the only long hop through it is known.
PlaceSet PlanarHops::FindBorder()
{
  const PlaceSet& points = this->Index.Occupied();
  PlaceSet filled = points;
  const auto besideCuts = [this](std::int64_t place)
  { return this->Cuts ? this->Cuts->BesideOpenFrom(place) : std::uint64_t(0); };
  if (this->North != NoHop)
  {
    filled.AddSurrounded(besideCuts);
  }
  const std::int64_t end = this->Index.NumberOfPlaces();
  for (std::int64_t place = 0; place < end; place += PlaceSet::WordBits)
  {
    const std::uint64_t besideGaps =
      std::uint64_t(points.From(place)) & (~filled.Surrounded(place) | besideCuts(place));
    this->BorderNumbers.Append(besideGaps);
    for (std::uint64_t left = besideGaps; left != 0; left &= left - 1)
    {
      this->Border.push_back(place + LowestBit(left));
    }
  }
  return filled;
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Visitor>
void PlanarHops::ForEachCandidate(const HopCandidates& candidates, const Monitor& monitor, Visitor&& visit) const
{
  for (std::size_t n = 0; n < this->Border.size(); ++n)
  {
    if (n % HopsPerBatch == 0)
    {
      monitor.Progress(double(n) / double(this->Border.size()));
    }
    const std::int64_t place = this->Border[n];
    const PlanePoint from{ std::int32_t(place % this->Index.Width()), std::int32_t(place / this->Index.Width()) };
    candidates.ForEach(place,
      [&](std::size_t number)
      {
        const PlanePoint& vector = this->Hops.Vector(this->Long[number].Hop);
        visit(PlacedHop{ from, { from.X + vector.X, from.Y + vector.Y }, std::int32_t(number) });
      });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::AddDirectHops(const HopCandidates& candidates, const Monitor& monitor)
{
  this->ForEachCandidate(candidates, monitor,
    [this](const PlacedHop& hop)
    {
      if (this->IsDirect(hop) && !this->IsOverCut(hop))
      {
        this->Add(hop);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Returns the candidates across cuts.
std::vector<PlanarHops::PlacedHop> PlanarHops::AddFurtherHops(const HopCandidates& candidates, const Monitor& monitor)
{
  std::vector<PlacedHop> left;
  std::vector<PlacedHop> across;
  this->ForEachCandidate(candidates, monitor.Step(0.0, 0.8),
    [&](const PlacedHop& hop)
    {
      if (this->IsCrossed(hop) || !candidates.IsFree(this->StartOf(hop), this->Long[hop.Number]))
      {
        return;
      }
      if (this->IsOverCut(hop))
      {
        across.push_back(hop);
      }
      else if (!this->IsDirect(hop))
      {
        left.push_back(hop);
      }
    });
  this->AddUncrossed(left, monitor.Step(0.8, 1.0));
  return across;
}

//----------------------------------------------------------------------------------------------------------------------
// Hops with equal vectors never cross, so that their order does not matter.
void PlanarHops::AddUncrossed(std::vector<PlacedHop>& hops, const Monitor& monitor)
{
  std::sort(hops.begin(), hops.end(), [](const PlacedHop& a, const PlacedHop& b) { return a.Number < b.Number; });
  for (std::size_t n = 0; n < hops.size(); ++n)
  {
    if (n % HopsPerBatch == 0)
    {
      monitor.Progress(double(n) / double(hops.size()));
    }
    if (!this->IsCrossed(hops[n]))
    {
      this->Add(hops[n]);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsDirect(const PlacedHop& hop) const
{
  const std::int64_t start = this->StartOf(hop);
  const std::vector<std::int64_t>& between = this->Long[hop.Number].Between;
  return std::none_of(between.begin(), between.end(), [&](std::int64_t offset) { return this->Has(start + offset); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsOverCut(const PlacedHop& hop) const
{
  const std::int64_t start = this->StartOf(hop);
  const std::vector<std::int64_t>& squares = this->Long[hop.Number].Squares;
  return this->Cuts &&
    std::any_of(
      squares.begin(), squares.end(), [&](std::int64_t square) { return this->Cuts->IsOpen(start + square); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsCrossed(const PlacedHop& hop) const
{
  const std::int64_t start = this->StartOf(hop);
  for (const std::int64_t square : this->Long[hop.Number].Squares)
  {
    std::int32_t link = this->First[start + square];
    while (link != NoLink)
    {
      const PlacedHop& other = this->Placed[this->Links[link].Hop];
      if (ProperlyCross(hop.From, hop.To, other.From, other.To))
      {
        return true;
      }
      link = this->Links[link].Next;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::Add(const PlacedHop& hop)
{
  const std::vector<std::int64_t>& squares = this->Long[hop.Number].Squares;
  if (this->Links.size() + squares.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
  {
    throw InputError("more than 2^31 unit squares that hops touch, expected fewer points or a smaller radius");
  }
  const std::int32_t number = std::int32_t(this->Placed.size());
  this->Placed.push_back(hop);
  const std::int64_t start = this->StartOf(hop);
  for (const std::int64_t square : squares)
  {
    std::int32_t& first = this->First[start + square];
    this->Links.push_back({ number, first });
    first = std::int32_t(this->Links.size()) - 1;
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Visitor>
void PlanarHops::ForEachShortHop(std::int64_t place, Visitor&& visit) const
{
  for (const HopId hop : this->Hops.ToNeighbours())
  {
    const PlanePoint& vector = this->Hops.Vector(hop);
    const std::int64_t neighbour = place + this->Hops.Offset(hop);
    if (this->Has(neighbour) && this->IsAdmissible(place, vector))
    {
      visit(hop);
    }
    else if (vector.X == 0 && !this->Has(neighbour) && this->IsSingleGap(neighbour))
    {
      visit(vector.Y < 0 ? this->South : this->North);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Of the two diagonals between four points the south-east to north-west one is admissible, as a sweep meets it first.
// With fewer points, or if cuts leave one diagonal, that one is.
bool PlanarHops::IsAdmissible(std::int64_t place, const PlanePoint& step) const
{
  const bool isOfFour =
    step.X * step.Y > 0 && this->Has(place + step.X) && this->Has(place + this->Hops.OffsetOf({ 0, step.Y }));
  if (this->Cuts && this->Cuts->IsBesideOpen(place))
  {
    return !this->Cuts->IsBarred(place, step) && (!isOfFour || this->Cuts->LeavesDiagonal(place, step));
  }
  return !isOfFour;
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsSingleGap(std::int64_t place) const
{
  return this->North != NoHop && !(this->Cuts && this->Cuts->IsBesideOpen(place)) &&
    std::all_of(this->Hops.ToNeighbours().begin(), this->Hops.ToNeighbours().end(),
      [&](HopId hop) { return this->Has(place + this->Hops.Offset(hop)); });
}

//----------------------------------------------------------------------------------------------------------------------
ItemLists<HopId> PlanarHops::ListByPoint(std::size_t admissible) const
{
  ItemLists<HopId> lists(this->BorderNumbers.Size(),
    [this, admissible](auto&& add)
    {
      for (const std::int64_t place : this->Border)
      {
        this->ForEachShortHop(place, [&](HopId hop) { add(this->BorderNumbers[place], hop); });
      }
      for (std::size_t n = 0; n < admissible; ++n)
      {
        const HopId hop = this->Long[this->Placed[n].Number].Hop;
        const std::int64_t start = this->StartOf(this->Placed[n]);
        add(this->BorderNumbers[start], hop);
        add(this->BorderNumbers[start + this->Hops.Offset(hop)], this->Hops.Opposite(hop));
      }
    });
  for (std::int64_t number = 0; number < this->BorderNumbers.Size(); ++number)
  {
    std::sort(lists.begin(number), lists.end(number));
  }
  return lists;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HopAcrossCut> PlanarHops::ListAcross(std::size_t admissible) const
{
  std::vector<HopAcrossCut> across;
  for (const std::int64_t place : this->Border)
  {
    for (const HopId hop : this->Hops.ToNeighbours())
    {
      if (this->Cuts && this->Cuts->IsBesideOpen(place) && this->IsShortAcross(place, this->Hops.Vector(hop)))
      {
        across.push_back({ place, hop });
      }
    }
  }
  for (std::size_t n = admissible; n < this->Placed.size(); ++n)
  {
    const HopId hop = this->Long[this->Placed[n].Number].Hop;
    const std::int64_t start = this->StartOf(this->Placed[n]);
    across.push_back({ start, hop });
    across.push_back({ start + this->Hops.Offset(hop), this->Hops.Opposite(hop) });
  }
  std::sort(across.begin(), across.end());
  return across;
}

//----------------------------------------------------------------------------------------------------------------------
// Both diagonals between four points are excluded, as they cross.
bool PlanarHops::IsShortAcross(std::int64_t place, const PlanePoint& step) const
{
  const bool isOfFour =
    step.X * step.Y != 0 && this->Has(place + step.X) && this->Has(place + this->Hops.OffsetOf({ 0, step.Y }));
  return this->Has(place + this->Hops.OffsetOf(step)) && !isOfFour && this->Cuts->IsBarred(place, step);
}

//----------------------------------------------------------------------------------------------------------------------
HopId PlanarHops::Next(std::int64_t place, HopId from) const
{
  const std::int64_t number = this->BorderNumbers[place];
  if (number == PlaceNumbers::None)
  {
    return this->NextShort(place, from);
  }
  const HopId* const first = this->Listed.begin(number);
  const HopId* const last = this->Listed.end(number);
  const HopId* const next = std::upper_bound(first, last, from);
  return next != last ? *next : first != last ? *first : NoHop;
}

//----------------------------------------------------------------------------------------------------------------------
HopId PlanarHops::NextShort(std::int64_t place, HopId from) const
{
  HopId first = NoHop;
  HopId next = NoHop;
  this->ForEachShortHop(place,
    [&](HopId hop)
    {
      first = first == NoHop ? hop : first;
      next = next == NoHop && hop > from ? hop : next;
    });
  return next != NoHop ? next : first;
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t PlanarHops::NumberOf(std::int64_t place, HopId hop) const
{
  const std::int64_t number = this->BorderNumbers[place];
  if (number == PlaceNumbers::None)
  {
    return this->Size();
  }
  const HopId* const last = this->Listed.end(number);
  const HopId* const found = std::lower_bound(this->Listed.begin(number), last, hop);
  return found != last && *found == hop ? this->Listed.IndexOf(found) : this->Size();
}

// ---- CutBlocks ------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
CutBlocks::CutBlocks(const LinkCuts& cuts, PlanePoints columns, const ColumnIndex& index)
  : Width(index.Width())
  , Flags(std::size_t(index.Width() * index.Height()), 0)
{
  const PlaneBox box(columns);
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    for (std::int32_t x = box.Least.X; x <= box.Greatest.X; ++x)
    {
      const unsigned flags =
        (cuts.IsCutEast({ x, y }) ? unsigned(CutEast) : 0U) | (cuts.IsCutNorth({ x, y }) ? unsigned(CutNorth) : 0U);
      if (flags != 0)
      {
        this->Add(index.Place({ x, y }), flags);
      }
    }
  }
  for (std::int64_t block = 0; block < std::int64_t(this->Flags.size()) - this->Width - 1; ++block)
  {
    this->OpenBlock(block);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CutBlocks::OpenBlock(std::int64_t block)
{
  const bool bottom = this->Has(block, CutEast);
  const bool top = this->Has(block + this->Width, CutEast);
  const bool left = this->Has(block, CutNorth);
  const bool right = this->Has(block + 1, CutNorth);
  const int sides = int(bottom) + int(top) + int(left) + int(right);
  if (sides == 0)
  {
    return;
  }
  const bool isCorner = sides == 2 && bottom != top;
  const unsigned diagonal = isCorner ? unsigned(bottom == left ? FallingLeft : RisingLeft) : 0U;
  this->Add(block, Open | diagonal);
  for (const std::int64_t corner : { block, block + 1, block + this->Width, block + this->Width + 1 })
  {
    this->Add(corner, BesideOpen);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::uint64_t CutBlocks::BesideOpenFrom(std::int64_t place) const
{
  const std::int64_t end = std::min<std::int64_t>(64, std::int64_t(this->Flags.size()) - place);
  std::uint64_t bits = 0;
  for (std::int64_t bit = 0; bit < end; ++bit)
  {
    bits |= std::uint64_t(this->IsBesideOpen(place + bit)) << bit;
  }
  return bits;
}
}
