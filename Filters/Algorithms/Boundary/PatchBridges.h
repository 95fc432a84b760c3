// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The graph whose faces are the boundaries by growth by distance (thesis Alg. 3.1): all hops to the eight neighbours,
// and longer ones, bridges, only where these leave parts unconnected. Bridges are taken from near to far, each if it
// joins parts that nothing joins yet; so they are a part of a shortest spanning tree, cross nothing (PlanarHops.h says
// why), close no loop, and are walked there and back.

#ifndef SeismicHorizonsPatchBridges_h
#define SeismicHorizonsPatchBridges_h

#include "BorderScan.h"

#include <array>
#include <vector>

namespace SeismicHorizons
{
/// Sweeps over the eight neighbours.
class NeighbourSweep
{
public:
  /// `hops` are those of k = 1.
  explicit NeighbourSweep(const ColumnRaster& raster, const HopVectors& hops);

  BorderTurn Turn(std::int64_t place, HopId from) const
  {
    bool passedEast = false;
    for (HopId turn = 1; turn <= 8; ++turn)
    {
      const HopId next = (from + turn) % 8;
      if (this->Raster[place + this->Offsets[std::size_t(next)]] != NoPoint)
      {
        return { next, passedEast };
      }
      passedEast = passedEast || next == this->East;
    }
    return { NoHop, passedEast };
  }

private:
  const ColumnRaster& Raster;
  std::array<std::int64_t, 8> Offsets;
  HopId East;
};

/// The bridges of a horizon.
class PatchBridges
{
public:
  /// `parts` are the boundaries of k = 1, on any raster.
  PatchBridges(const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops,
    const ExteriorBoundary& parts);

  bool IsEmpty() const { return this->Ends.empty(); }

  /// The first bridge from a place in a clockwise sweep after a hop; NoHop when there is none.
  HopId Next(std::int64_t place, HopId from) const;

private:
  struct End
  {
    std::int64_t Place;
    HopId Hop;
  };

  void Join(const std::vector<std::int64_t>& border, const ExteriorBoundary& parts);
  void AddEnd(std::int64_t place, HopId hop);

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  std::vector<End> Ends; // by place, then hop
  std::vector<bool> HasEnd; // by point
};

/// Sweeps over the eight neighbours and the bridges.
class BridgeSweep
{
public:
  BridgeSweep(const ColumnRaster& raster, const HopVectors& hops, const PatchBridges& bridges);

  BorderTurn Turn(std::int64_t place, HopId from) const;

private:
  /// How many hops a clockwise sweep meets between two.
  HopId Between(HopId from, HopId to) const { return (to > from ? to : to + this->Hops.Size()) - from; }

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  const PatchBridges& Bridges;
  std::array<HopId, 8> Neighbours;
  HopId East;
};
}

#endif
