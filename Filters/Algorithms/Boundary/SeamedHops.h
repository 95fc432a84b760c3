// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The graph of all hops to the eight neighbours, and through the gaps of seams (SeamGaps.h), for BorderScan.

#ifndef SeismicHorizonsSeamedHops_h
#define SeismicHorizonsSeamedHops_h

#include "BorderScan.h"
#include "SeamGaps.h"

#include <array>

namespace SeismicHorizons
{
class SeamedHops
{
public:
  /// `hops` are those of k = 1. Keeps references to the raster and the gaps.
  SeamedHops(const ColumnRaster& raster, const HopVectors& hops, const SeamGaps& gaps)
    : Raster(raster)
    , Gaps(gaps)
    , East(hops.Find({ 1, 0 }))
    , West(hops.Find({ -1, 0 }))
  {
    for (HopId hop = 0; hop < hops.Size(); ++hop)
    {
      this->Offsets[std::size_t(hop)] = hops.Offset(hop);
    }
  }

  SweepResult Sweep(std::int64_t place, HopId from) const
  {
    if (this->Gaps.Has(place))
    {
      return { from == this->West ? this->East : this->West, false };
    }
    bool passedEast = false;
    for (HopId step = 1; step <= 8; ++step)
    {
      const HopId next = (from + step) % 8;
      if (this->Leads(place, next))
      {
        return { next, passedEast };
      }
      passedEast = passedEast || next == this->East;
    }
    return { NoHop, passedEast };
  }

  bool LeadsEast(std::int64_t place) const { return this->Leads(place, this->East); }

private:
  bool Leads(std::int64_t place, HopId hop) const
  {
    const std::int64_t end = place + this->Offsets[std::size_t(hop)];
    return this->Raster[end] != NoPoint || ((hop == this->East || hop == this->West) && this->Gaps.Has(end));
  }

  const ColumnRaster& Raster;
  const SeamGaps& Gaps;
  std::array<std::int64_t, 8> Offsets;
  const HopId East;
  const HopId West;
};
}

#endif
