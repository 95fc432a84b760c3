// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchBridges.h"

#include "Common/DisjointSets.h"
#include "LongHops.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
/// The hops that lead further than to a neighbour, those with the nearest ends first. Of two opposite ones only that
/// which leads upwards or straight to the right.
std::vector<HopId> FindLongHops(const HopVectors& hops)
{
  std::vector<HopId> result;
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    const PlanePoint& vector = hops.Vector(hop);
    if (LongHops::IsLongAndRising(vector))
    {
      result.push_back(hop);
    }
  }
  std::stable_sort(
    result.begin(), result.end(), [&hops](HopId a, HopId b) { return IsNearer(hops.Vector(a), hops.Vector(b)); });
  return result;
}

/// The places that loops visit, row by row.
std::vector<std::int64_t> FindPlaces(
  const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const Loops& loops)
{
  std::vector<std::int64_t> places;
  places.reserve(loops.TotalLength());
  loops.ForEachPoint([&](PointId point) { places.push_back(raster.Place(columns[std::size_t(point)])); });
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}
}

//----------------------------------------------------------------------------------------------------------------------
NeighbourHops::NeighbourHops(const ColumnRaster& raster, const HopVectors& hops)
  : Raster(raster)
  , East(hops.Find({ 1, 0 }))
{
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    this->Offsets[std::size_t(hop)] = hops.Offset(hop);
  }
}

//----------------------------------------------------------------------------------------------------------------------
PatchBridges::PatchBridges(const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops,
  const ExteriorBoundary& parts)
  : Raster(raster)
  , Hops(hops)
  , HasEnd(columns.size(), false)
{
  if (parts.NumberOfPatches > 1)
  {
    this->Join(FindPlaces(columns, raster, parts.Boundary), parts);
  }
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const End& a, const End& b) { return a.Place != b.Place ? a.Place < b.Place : a.Hop < b.Hop; });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchBridges::Join(const std::vector<std::int64_t>& onLoops, const ExteriorBoundary& parts)
{
  const auto part = [&](std::int64_t place) { return parts.Patch[std::size_t(this->Raster[place])]; };
  DisjointSets joined(parts.NumberOfPatches);
  for (const HopId hop : FindLongHops(this->Hops))
  {
    for (const std::int64_t place : onLoops)
    {
      const std::int64_t end = place + this->Hops.Offset(hop);
      if (this->Raster[end] != NoPoint && part(place) != part(end) && joined.Join(part(place), part(end)))
      {
        this->AddEnd(place, hop);
        this->AddEnd(end, this->Hops.Opposite(hop));
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PatchBridges::AddEnd(std::int64_t place, HopId hop)
{
  this->Ends.push_back({ place, hop });
  this->HasEnd[std::size_t(this->Raster[place])] = true;
}

//----------------------------------------------------------------------------------------------------------------------
HopId PatchBridges::Next(std::int64_t place, HopId from) const
{
  if (!this->HasEnd[std::size_t(this->Raster[place])])
  {
    return NoHop;
  }
  auto end = std::lower_bound(
    this->Ends.begin(), this->Ends.end(), place, [](const End& a, std::int64_t b) { return a.Place < b; });
  HopId best = NoHop;
  const auto order = [&](HopId hop) { return hop > from ? hop : hop + this->Hops.Size(); };
  for (; end != this->Ends.end() && end->Place == place; ++end)
  {
    best = best == NoHop || order(end->Hop) < order(best) ? end->Hop : best;
  }
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
BridgedHops::BridgedHops(const ColumnRaster& raster, const HopVectors& hops, const PatchBridges& bridges)
  : Raster(raster)
  , Hops(hops)
  , Bridges(bridges)
  , East(hops.Find({ 1, 0 }))
{
  std::size_t found = 0;
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    if (ChebyshevLength(hops.Vector(hop)) == 1)
    {
      this->Neighbours[found++] = hop;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SweepResult BridgedHops::Sweep(std::int64_t place, HopId from) const
{
  HopId next = this->Bridges.Next(place, from);
  for (const HopId hop : this->Neighbours)
  {
    const bool isSooner = next == NoHop || this->Between(from, hop) < this->Between(from, next);
    if (isSooner && this->Raster[place + this->Hops.Offset(hop)] != NoPoint)
    {
      next = hop;
    }
  }
  const bool isEastEmpty = this->Raster[place + this->Hops.Offset(this->East)] == NoPoint;
  return { next, isEastEmpty && (next == NoHop || this->Between(from, this->East) < this->Between(from, next)) };
}
}
