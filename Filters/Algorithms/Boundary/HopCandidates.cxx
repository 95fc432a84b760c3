// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HopCandidates.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
HopCandidates::HopCandidates(
  const ColumnRaster& raster, const PlaceSet& points, const HopVectors& hops, const LongHops& longHops)
  : Raster(raster)
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
    this->Ends[std::size_t(end.Y)] |= Window(1) << (end.X + this->Radius);
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

//----------------------------------------------------------------------------------------------------------------------
void HopCandidates::AddToShadow(std::size_t kind, const PlanePoint& column, const PlanePoint& end)
{
  const PlanePoint step = kind == Itself ? PlanePoint{} : NeighbourSteps[kind];
  const PlanePoint other{ column.X + step.X, column.Y + step.Y };
  if (ChebyshevLength(column) <= NearRadius && ChebyshevLength(other) <= NearRadius && column.Y >= 0)
  {
    this->Shadows[Slot(kind, column.X, column.Y)][std::size_t(end.Y)] |= Window(1) << (end.X + this->Radius);
  }
}

//----------------------------------------------------------------------------------------------------------------------
HopCandidates::NearRows HopCandidates::NearRowsAt(std::int64_t from, std::int32_t radius) const
{
  const unsigned columns = ((1U << (2 * radius + 1)) - 1) << (NearRadius - radius);
  NearRows near = {};
  for (std::int32_t row = 0; row <= radius; ++row)
  {
    near[std::size_t(row)] = unsigned(this->Points.From(from + row * this->Raster.Width() - NearRadius)) & columns;
  }
  return near;
}

//----------------------------------------------------------------------------------------------------------------------
void HopCandidates::FindEndsBeyondNearest(std::int64_t from, Rows& ends) const
{
  const NearRows near = this->NearRowsAt(from, NearestRadius);
  unsigned bits = 0;
  for (std::int32_t row = NearestRadius; row >= 0; --row)
  {
    bits = bits << (2 * NearestRadius + 1) | near[std::size_t(row)] >> (NearRadius - NearestRadius);
  }
  std::int32_t& number = this->OpenNumbers[bits];
  if (number < 0)
  {
    number = std::int32_t(this->OpenByNearest.size());
    this->OpenByNearest.push_back(this->Ends);
    this->RuleOut(near, this->OpenByNearest.back());
  }
  const Rows& open = this->OpenByNearest[std::size_t(number)];
  for (std::int32_t row = 0; row <= this->Radius; ++row)
  {
    const Window left = open[std::size_t(row)];
    ends[std::size_t(row)] =
      left == 0 ? left : left & this->Points.From(from + row * this->Raster.Width() - this->Radius);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HopCandidates::RuleOut(const NearRows& near, Rows& ends) const
{
  for (std::int32_t row = 0; row <= NearRadius; ++row)
  {
    const unsigned here = near[std::size_t(row)];
    const unsigned above = near[std::size_t(row) + 1];
    // In the order of NeighbourSteps.
    const std::array<unsigned, Kinds> found = { here & here >> 1U, here & above >> 1U, here & above, here & above << 1U,
      here };
    for (std::size_t kind = 0; kind < Kinds; ++kind)
    {
      for (unsigned columns = found[kind]; columns != 0; columns &= columns - 1)
      {
        const Rows& shadow = this->Shadows[Slot(kind, __builtin_ctz(columns) - NearRadius, row)];
        for (std::size_t n = std::size_t(row); n <= std::size_t(this->Radius); ++n)
        {
          ends[n] &= ~shadow[n];
        }
      }
    }
  }
}
}
