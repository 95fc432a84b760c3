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
PlanarHops::PlanarHops(const ColumnRaster& raster, std::size_t points, const HopVectors& hops, const Monitor& monitor)
  : Raster(raster)
  , Hops(hops)
  , Long(hops)
  , IsOnBorder(points, false)
{
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    const PlanePoint& vector = hops.Vector(hop);
    if (ChebyshevLength(vector) == 1)
    {
      this->Short.push_back(hop);
      // Of the two diagonals between four neighbouring points a sweep meets that from south-east to north-west first.
      if (vector.X * vector.Y <= 0)
      {
        this->Inner.push_back(hop);
      }
    }
  }
  this->FindBorder();
  this->First.assign(std::size_t(raster.Width() * raster.Height()), NoLink);
  const HopCandidates candidates(raster, hops, this->Long);
  this->AddDirectHops(candidates, monitor.Step(0.0, 0.4));
  this->AddFurtherHops(candidates, monitor.Step(0.4, 0.9));
  std::vector<std::int32_t>().swap(this->First);
  std::vector<Link>().swap(this->Links);
  this->Listed = this->ListByPoint(points);
  std::vector<PlacedHop>().swap(this->Placed);
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::FindBorder()
{
  const std::int64_t up = this->Raster.Width();
  for (std::int64_t place = up; place < up * (this->Raster.Height() - 1); ++place)
  {
    if (this->Has(place) &&
      !std::all_of(
        this->Short.begin(), this->Short.end(), [&](HopId hop) { return this->Has(place + this->Hops.Offset(hop)); }))
    {
      this->IsOnBorder[std::size_t(this->Raster[place])] = true;
      this->Border.push_back(place);
    }
  }
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
    candidates.ForEach(from,
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
      if (this->IsDirect(hop))
      {
        this->Add(hop);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::AddFurtherHops(const HopCandidates& candidates, const Monitor& monitor)
{
  std::vector<PlacedHop> left;
  this->ForEachCandidate(candidates, monitor.Step(0.0, 0.8),
    [&](const PlacedHop& hop)
    {
      if (!this->IsCrossed(hop) && candidates.IsFree(this->StartOf(hop), this->Long[std::size_t(hop.Number)]) &&
        !this->IsDirect(hop))
      {
        left.push_back(hop);
      }
    });
  // Hops with the same vector never cross, so that their order does not matter.
  std::sort(left.begin(), left.end(), [](const PlacedHop& a, const PlacedHop& b) { return a.Number < b.Number; });
  for (std::size_t n = 0; n < left.size(); ++n)
  {
    if (n % Batch == 0)
    {
      monitor.Progress(0.8 + 0.2 * double(n) / double(left.size()));
    }
    if (!this->IsCrossed(left[n]))
    {
      this->Add(left[n]);
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
// Of the two diagonals between four neighbouring points one is admissible; between fewer points each is.
template <typename Visitor>
void PlanarHops::ForEachShortHop(std::int64_t place, Visitor&& visit) const
{
  for (const HopId hop : this->Short)
  {
    const PlanePoint& vector = this->Hops.Vector(hop);
    const bool isOfFour =
      vector.X * vector.Y > 0 && this->Has(place + vector.X) && this->Has(place + this->Hops.OffsetOf({ 0, vector.Y }));
    if (this->Has(place + this->Hops.Offset(hop)) && !isOfFour)
    {
      visit(hop);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
ItemLists<HopId> PlanarHops::ListByPoint(std::size_t points) const
{
  ItemLists<HopId> lists(std::int64_t(points),
    [this](auto&& add)
    {
      for (const std::int64_t place : this->Border)
      {
        this->ForEachShortHop(place, [&](HopId hop) { add(this->Raster[place], hop); });
      }
      for (const PlacedHop& placed : this->Placed)
      {
        const HopId hop = this->Long[std::size_t(placed.Number)].Hop;
        const std::int64_t start = this->StartOf(placed);
        add(this->Raster[start], hop);
        add(this->Raster[start + this->Hops.Offset(hop)], this->Hops.Opposite(hop));
      }
    });
  for (std::int64_t point = 0; point < std::int64_t(points); ++point)
  {
    std::sort(lists.begin(point), lists.end(point));
  }
  return lists;
}

//----------------------------------------------------------------------------------------------------------------------
HopId PlanarHops::Next(std::int64_t place, HopId from) const
{
  const PointId point = this->Raster[place];
  const bool isListed = this->IsOnBorder[std::size_t(point)];
  const HopId* const first = isListed ? this->Listed.begin(point) : this->Inner.data();
  const HopId* const last = isListed ? this->Listed.end(point) : first + this->Inner.size();
  const HopId* const next = std::upper_bound(first, last, from);
  return next != last ? *next : first != last ? *first : NoHop;
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t PlanarHops::NumberOf(PointId point, HopId hop) const
{
  const HopId* const last = this->Listed.end(point);
  const HopId* const found = std::lower_bound(this->Listed.begin(point), last, hop);
  return found != last && *found == hop ? this->Listed.IndexOf(found) : this->Size();
}
}
