// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HopCandidates.h"

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t BitsPerWord = 64;
}

//----------------------------------------------------------------------------------------------------------------------
HopCandidates::HopCandidates(const ColumnRaster& raster, const HopVectors& hops, const LongHops& longHops)
  : Raster(raster)
  , Long(longHops)
  , Radius(hops.Radius())
  , WordsPerRow(raster.Width() / BitsPerWord + 1)
  , Words(std::size_t(this->WordsPerRow * raster.Height() + 2), 0)
  , Ends()
  , Shadows(Slot(Kinds, -NearRadius, 0), this->Ends)
{
  for (std::int64_t y = 0; y < raster.Height(); ++y)
  {
    for (std::int64_t x = 0; x < raster.Width(); ++x)
    {
      this->Words[std::size_t(y * this->WordsPerRow + x / BitsPerWord)] |=
        std::uint64_t(raster[y * raster.Width() + x] != NoPoint) << (x % BitsPerWord);
    }
  }
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
void HopCandidates::RuleOut(const PlanePoint& from, Rows& open) const
{
  std::array<unsigned, NearRadius + 2> near = {}; // a row at a time, and an empty one
  for (std::int32_t row = 0; row <= NearRadius; ++row)
  {
    near[std::size_t(row)] = unsigned(this->BitsAt(from.X - NearRadius, from.Y + row)) & ((1U << NearWidth) - 1);
  }
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
          open[n] &= ~shadow[n];
        }
      }
    }
  }
}
}
