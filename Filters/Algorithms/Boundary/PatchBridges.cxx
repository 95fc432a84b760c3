// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PatchBridges.h"

#include "PatchComponents.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
/// Upwards or level hops that lead further than to a neighbour, near ones first.
std::vector<HopId> LongHops(const HopVectors& hops)
{
  std::vector<HopId> result;
  for (HopId hop = 0; hop < hops.Size(); ++hop)
  {
    const PlanePoint& vector = hops.Vector(hop);
    if (ChebyshevLength(vector) > 1 && (vector.Y > 0 || (vector.Y == 0 && vector.X > 0)))
    {
      result.push_back(hop);
    }
  }
  std::stable_sort(
    result.begin(), result.end(), [&hops](HopId a, HopId b) { return IsNearer(hops.Vector(a), hops.Vector(b)); });
  return result;
}

/// The places on the loops, row by row.
std::vector<std::int64_t> BorderPlaces(
  const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const Loops& loops)
{
  std::vector<std::int64_t> places;
  places.reserve(loops.TotalLength());
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    std::for_each(loops.begin(loop), loops.end(loop),
      [&](PointId point) { places.push_back(raster.Place(columns[std::size_t(point)])); });
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}
}

//----------------------------------------------------------------------------------------------------------------------
NeighbourSweep::NeighbourSweep(const ColumnRaster& raster, const HopVectors& hops)
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
    this->Join(BorderPlaces(columns, raster, parts.Boundary), parts);
  }
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const End& a, const End& b) { return a.Place != b.Place ? a.Place < b.Place : a.Hop < b.Hop; });
}

//----------------------------------------------------------------------------------------------------------------------
void PatchBridges::Join(const std::vector<std::int64_t>& border, const ExteriorBoundary& parts)
{
  const auto part = [&](std::int64_t place) { return parts.Patch[std::size_t(this->Raster[place])]; };
  DisjointSets joined;
  for (std::size_t n = 0; n < parts.NumberOfPatches; ++n)
  {
    joined.Add();
  }
  for (const HopId hop : LongHops(this->Hops))
  {
    for (const std::int64_t place : border)
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
  const auto turn = [&](HopId hop) { return hop > from ? hop : hop + this->Hops.Size(); };
  for (; end != this->Ends.end() && end->Place == place; ++end)
  {
    best = best == NoHop || turn(end->Hop) < turn(best) ? end->Hop : best;
  }
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
BridgeSweep::BridgeSweep(const ColumnRaster& raster, const HopVectors& hops, const PatchBridges& bridges)
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
BorderTurn BridgeSweep::Turn(std::int64_t place, HopId from) const
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
