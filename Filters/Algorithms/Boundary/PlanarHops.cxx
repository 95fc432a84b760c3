// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlanarHops.h"

#include "Common/Predicates.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
// Walks ask about the same hops again soon, or not at all.
constexpr std::size_t MostAnswersToKeep = 1 << 14;

PlanePoint Sum(const PlanePoint& a, const PlanePoint& b)
{
  return { a.X + b.X, a.Y + b.Y };
}

PlanePoint Difference(const PlanePoint& a, const PlanePoint& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

bool IsRising(const PlanePoint& vector)
{
  return vector.Y > 0 || (vector.Y == 0 && vector.X > 0);
}
}

//----------------------------------------------------------------------------------------------------------------------
PlanarHops::PlanarHops(const ColumnRaster& raster, const HopVectors& hops)
  : Raster(raster)
  , Hops(hops)
  , InTheWay(std::size_t(hops.Size()))
{
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    if (IsRising(hops.Vector(hop)))
    {
      this->Rising.push_back(hop);
      this->FindPlaces(hop);
    }
  }
  std::sort(this->Rising.begin(), this->Rising.end(), [this](HopId a, HopId b) { return this->IsBefore(a, b); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsBefore(HopId a, HopId b) const
{
  const std::int64_t lengthA = SquaredLength(this->Hops.Vector(a));
  const std::int64_t lengthB = SquaredLength(this->Hops.Vector(b));
  return lengthA != lengthB ? lengthA < lengthB : a < b;
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::FindPlaces(HopId hop)
{
  const PlanePoint& end = this->Hops.Vector(hop);
  Obstacles& obstacles = this->InTheWay[std::size_t(hop)];
  for (HopId other = 0; other < this->Hops.Size(); ++other)
  {
    const PlanePoint& place = this->Hops.Vector(other);
    if (OnOpenSegment({ 0, 0 }, end, place))
    {
      obstacles.Over.push_back(this->Hops.Offset(other));
    }
    if (IsNearer(place, end) && IsNearer(Difference(end, place), end))
    {
      obstacles.Between.push_back(this->Hops.Offset(other));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PlanarHops::FindCrossings(HopId hop)
{
  const PlanePoint& end = this->Hops.Vector(hop);
  const std::int32_t reach = this->Hops.Radius();
  Obstacles& obstacles = this->InTheWay[std::size_t(hop)];
  for (const HopId other : this->Rising)
  {
    const PlanePoint& way = this->Hops.Vector(other);
    for (std::int32_t y = -reach; y <= end.Y; ++y)
    {
      for (std::int32_t x = std::min(0, end.X) - reach; x <= std::max(0, end.X) + reach; ++x)
      {
        const PlanePoint from{ x, y };
        if (ProperlyCross({ 0, 0 }, end, from, Sum(from, way)))
        {
          obstacles.Crossings.push_back({ this->Hops.OffsetOf(from), other, this->IsBefore(other, hop) });
        }
      }
    }
  }
  obstacles.HasCrossings = true;
}

//----------------------------------------------------------------------------------------------------------------------
HopId PlanarHops::Next(std::int64_t place, HopId from)
{
  const HopId size = this->Hops.Size();
  HopId hop = from;
  do
  {
    hop = hop + 1 < size ? hop + 1 : 0;
    if (this->Has(place + this->Hops.Offset(hop)) && this->IsAdmissible(place, hop))
    {
      return hop;
    }
  } while (hop != from);
  return NoHop;
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsAdmissible(std::int64_t place, HopId hop)
{
  if (!IsRising(this->Hops.Vector(hop)))
  {
    place += this->Hops.Offset(hop);
    hop = this->Hops.Opposite(hop);
  }
  const std::vector<std::int64_t>& over = this->InTheWay[std::size_t(hop)].Over;
  if (std::any_of(over.begin(), over.end(), [&](std::int64_t offset) { return this->Has(place + offset); }))
  {
    return false;
  }
  if (this->IsDirect(place, hop))
  {
    return true;
  }
  const std::int64_t key = place * this->Hops.Size() + hop;
  const auto known = this->Known.find(key);
  if (known != this->Known.end())
  {
    return known->second;
  }
  const bool admissible = !this->IsCrossed(place, hop);
  if (this->Known.size() >= MostAnswersToKeep)
  {
    this->Known.clear();
  }
  this->Known.emplace(key, admissible);
  return admissible;
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsDirect(std::int64_t place, HopId hop) const
{
  const std::vector<std::int64_t>& between = this->InTheWay[std::size_t(hop)].Between;
  return std::none_of(between.begin(), between.end(), [&](std::int64_t offset) { return this->Has(place + offset); });
}

//----------------------------------------------------------------------------------------------------------------------
bool PlanarHops::IsCrossed(std::int64_t place, HopId hop)
{
  if (!this->InTheWay[std::size_t(hop)].HasCrossings)
  {
    this->FindCrossings(hop);
  }
  const std::vector<Crossing>& crossings = this->InTheWay[std::size_t(hop)].Crossings;
  return std::any_of(crossings.begin(), crossings.end(),
    [&](const Crossing& crossing)
    {
      const std::int64_t from = place + crossing.Offset;
      return this->Has(from) && this->Has(from + this->Hops.Offset(crossing.Hop)) &&
        (crossing.IsBefore ? this->IsAdmissible(from, crossing.Hop) : this->IsDirect(from, crossing.Hop));
    });
}
}
