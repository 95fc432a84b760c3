// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlanarHops.h"

#include "Common/Errors.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int32_t NoLink = -1;

constexpr std::size_t Batch = 4096; // points from one report of progress to the next
}

//----------------------------------------------------------------------------------------------------------------------
PlanarHops::PlanarHops(const ColumnRaster& raster, const HopVectors& hops, const SeamGaps& gaps, const CutBlocks* cuts,
  const Monitor& monitor)
  : Raster(raster)
  , Hops(hops)
  , Gaps(gaps)
  , Cuts(cuts)
  , Long(hops)
  , South(hops.Radius() > 1 ? hops.Find({ 0, -2 }) : NoHop)
  , North(hops.Radius() > 1 ? hops.Find({ 0, 2 }) : NoHop)
{
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    if (ChebyshevLength(hops.Vector(hop)) == 1)
    {
      this->Short.push_back(hop);
    }
  }
  const PlaceSet filled = this->FindBorder();
  this->First.assign(std::size_t(raster.Width() * raster.Height()), NoLink);
  const HopCandidates candidates(raster, filled, hops, this->Long);
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
// Gives the places of points and of single empty columns. No other long hop than that over such a column leads there,
// so that it counts as a point when long hops are looked for.
PlaceSet PlanarHops::FindBorder()
{
  const PlaceSet points(this->Raster);
  PlaceSet filled = points;
  const auto besideCuts = [this](std::int64_t place)
  { return this->Cuts ? this->Cuts->BesideOpenFrom(place) : std::uint64_t(0); };
  if (this->North != NoHop)
  {
    filled.AddSurrounded(besideCuts);
  }
  const std::int64_t end = this->Raster.Width() * this->Raster.Height();
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
// Calls visit(hop) for the long hops between points that points near their starts do not rule out.
template <typename Visitor>
void PlanarHops::ForEachCandidate(const HopCandidates& candidates, const Monitor& monitor, Visitor&& visit) const
{
  for (std::size_t n = 0; n < this->Border.size(); ++n)
  {
    if (n % Batch == 0)
    {
      monitor.Progress(double(n) / double(this->Border.size()));
    }
    const std::int64_t place = this->Border[n];
    const PlanePoint from{ std::int32_t(place % this->Raster.Width()), std::int32_t(place / this->Raster.Width()) };
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
// Gives the candidates across cuts.
std::vector<PlanarHops::PlacedHop> PlanarHops::AddFurtherHops(const HopCandidates& candidates, const Monitor& monitor)
{
  std::vector<PlacedHop> left;
  std::vector<PlacedHop> across;
  this->ForEachCandidate(candidates, monitor.Step(0.0, 0.8),
    [&](const PlacedHop& hop)
    {
      if (this->IsCrossed(hop) || !candidates.IsFree(this->StartOf(hop), this->Long[std::size_t(hop.Number)]))
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
// From short to long, each that crosses none before it. Hops with the same vector never cross, so that their order does
// not matter.
void PlanarHops::AddUncrossed(std::vector<PlacedHop>& hops, const Monitor& monitor)
{
  std::sort(hops.begin(), hops.end(), [](const PlacedHop& a, const PlacedHop& b) { return a.Number < b.Number; });
  for (std::size_t n = 0; n < hops.size(); ++n)
  {
    if (n % Batch == 0)
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
  const std::vector<std::int64_t>& between = this->Long[std::size_t(hop.Number)].Between;
  return std::none_of(between.begin(), between.end(), [&](std::int64_t offset) { return this->Has(start + offset); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsOverCut(const PlacedHop& hop) const
{
  const std::int64_t start = this->StartOf(hop);
  const std::vector<std::int64_t>& squares = this->Long[std::size_t(hop.Number)].Squares;
  return this->Cuts &&
    std::any_of(
      squares.begin(), squares.end(), [&](std::int64_t square) { return this->Cuts->IsOpen(start + square); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsCrossed(const PlacedHop& hop) const
{
  const std::int64_t start = this->StartOf(hop);
  for (const std::int64_t square : this->Long[std::size_t(hop.Number)].Squares)
  {
    std::int32_t link = this->First[std::size_t(start + square)];
    while (link != NoLink)
    {
      const PlacedHop& other = this->Placed[std::size_t(this->Links[std::size_t(link)].Hop)];
      if (ProperlyCross(hop.From, hop.To, other.From, other.To))
      {
        return true;
      }
      link = this->Links[std::size_t(link)].Next;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::Add(const PlacedHop& hop)
{
  const std::vector<std::int64_t>& squares = this->Long[std::size_t(hop.Number)].Squares;
  if (this->Links.size() + squares.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
  {
    throw InputError("more than 2^31 unit squares that hops touch, expected fewer points or a smaller radius");
  }
  const std::int32_t number = std::int32_t(this->Placed.size());
  this->Placed.push_back(hop);
  const std::int64_t start = this->StartOf(hop);
  for (const std::int64_t square : squares)
  {
    std::int32_t& first = this->First[std::size_t(start + square)];
    this->Links.push_back({ number, first });
    first = std::int32_t(this->Links.size()) - 1;
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Calls visit(hop) for the admissible hops from a place to neighbours, over single empty columns, and into the gaps of
// seams.
template <typename Visitor>
void PlanarHops::ForEachShortHop(std::int64_t place, Visitor&& visit) const
{
  for (const HopId hop : this->Short)
  {
    const PlanePoint& vector = this->Hops.Vector(hop);
    const std::int64_t neighbour = place + this->Hops.Offset(hop);
    if ((this->Has(neighbour) && this->IsAdmissible(place, vector)) || (vector.Y == 0 && this->Gaps.Has(neighbour)))
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
// Whether a hop between two neighbouring points is admissible. Of the two diagonals between four points that from
// south-east to north-west is, as a sweep meets it first; between fewer points each is, and where cuts leave just one.
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
    std::all_of(
      this->Short.begin(), this->Short.end(), [&](HopId hop) { return this->Has(place + this->Hops.Offset(hop)); });
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
        const HopId hop = this->Long[std::size_t(this->Placed[n].Number)].Hop;
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
    if (this->Cuts && this->Cuts->IsBesideOpen(place))
    {
      std::for_each(this->Short.begin(), this->Short.end(),
        [&](HopId hop) {
          this->IsShortAcross(place, this->Hops.Vector(hop)) ? across.push_back({ place, hop }) : void();
        });
    }
  }
  for (std::size_t n = admissible; n < this->Placed.size(); ++n)
  {
    const HopId hop = this->Long[std::size_t(this->Placed[n].Number)].Hop;
    const std::int64_t start = this->StartOf(this->Placed[n]);
    across.push_back({ start, hop });
    across.push_back({ start + this->Hops.Offset(hop), this->Hops.Opposite(hop) });
  }
  std::sort(across.begin(), across.end());
  return across;
}

//----------------------------------------------------------------------------------------------------------------------
// For a place beside an open block. Of the diagonals between four points none is taken, as those of open blocks cross.
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
    return this->Gaps.Has(place) ? this->Hops.Opposite(from) : this->NextShort(place, from);
  }
  const HopId* const first = this->Listed.begin(number);
  const HopId* const last = this->Listed.end(number);
  const HopId* const next = std::upper_bound(first, last, from);
  return next != last ? *next : first != last ? *first : NoHop;
}

//----------------------------------------------------------------------------------------------------------------------
// The same for points that are not beside gaps.
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
}
