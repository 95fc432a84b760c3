// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The graph whose faces are the loops of growth by distance (thesis Alg. 3.1): all hops to the eight neighbours, and
// longer ones, called bridges, where those leave parts of a patch unconnected. Bridges are taken from the nearest to
// the farthest end, each if it joins parts that are not joined yet. So they belong to a shortest spanning tree, cross
// nothing (PlanarHops.h says why) and enclose nothing, and the walk takes each there and back.

#ifndef SeismicHorizonsPatchBridges_h
#define SeismicHorizonsPatchBridges_h

#include "BorderScan.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
/// The graph of all hops to the eight neighbours, for BorderScan.
class NeighbourHops
{
public:
  /// `hops` are those of k = 1.
  explicit NeighbourHops(const ColumnRaster& raster, const HopVectors& hops);

  SweepResult Sweep(std::int64_t place, HopId from) const
  {
    bool passedEast = false;
    for (HopId step = 1; step <= 8; ++step)
    {
      const HopId next = (from + step) % 8;
      if (this->Raster[place + this->Offsets[std::size_t(next)]] != NoPoint)
      {
        return { next, passedEast };
      }
      passedEast = passedEast || next == this->East;
    }
    return { NoHop, passedEast };
  }

  bool LeadsEast(std::int64_t place) const { return this->Raster[place + 1] != NoPoint; }

private:
  const ColumnRaster& Raster;
  std::array<std::int64_t, 8> Offsets;
  HopId East;
};

/// The bridges of a horizon.
class PatchBridges
{
public:
  /// `parts` is the boundary of k = 1, whose patches are the parts to join.
  PatchBridges(const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops,
    const ExteriorBoundary& parts);

  bool IsEmpty() const { return this->Ends.empty(); }

  /// The first bridge from a place that a clockwise sweep after `from` meets; NoHop when there is none.
  HopId Next(std::int64_t place, HopId from) const;

private:
  /// One end of a bridge, and the hop from there to the other end.
  struct End
  {
    std::int64_t Place;
    HopId Hop;
  };

  void Join(const std::vector<std::int64_t>& onLoops, const ExteriorBoundary& parts);
  void AddEnd(std::int64_t place, HopId hop);

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  std::vector<End> Ends; // by place, then hop
  std::vector<bool> HasEnd; // by point
};

/// The graph of the hops to the eight neighbours and of bridges, for BorderScan.
class BridgedHops
{
public:
  BridgedHops(const ColumnRaster& raster, const HopVectors& hops, const PatchBridges& bridges);

  SweepResult Sweep(std::int64_t place, HopId from) const;
  bool LeadsEast(std::int64_t place) const { return this->Raster[place + 1] != NoPoint; }

private:
  /// By how many hops a clockwise sweep turns from one to another.
  HopId Between(HopId from, HopId to) const { return (to > from ? to : to + this->Hops.Size()) - from; }

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  const PatchBridges& Bridges;
  std::array<HopId, 8> Neighbours;
  HopId East;
};
}

#endif
