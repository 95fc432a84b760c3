// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutBlocks.h"

#include "Common/Horizon/PlaneGeometry.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
CutBlocks::CutBlocks(const LinkCuts& cuts, PlanePoints columns, const ColumnIndex& index)
  : Width(index.Width())
  , Flags(std::size_t(index.Width() * index.Height()), 0)
{
  const PlaneBox box(columns);
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    for (std::int32_t x = box.Least.X; x <= box.Greatest.X; ++x)
    {
      const unsigned flags =
        (cuts.IsCutEast({ x, y }) ? unsigned(CutEast) : 0U) | (cuts.IsCutNorth({ x, y }) ? unsigned(CutNorth) : 0U);
      if (flags != 0)
      {
        this->Add(index.Place({ x, y }), flags);
      }
    }
  }
  for (std::int64_t block = 0; block < std::int64_t(this->Flags.size()) - this->Width - 1; ++block)
  {
    this->OpenBlock(block);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CutBlocks::OpenBlock(std::int64_t block)
{
  const bool bottom = this->Has(block, CutEast);
  const bool top = this->Has(block + this->Width, CutEast);
  const bool left = this->Has(block, CutNorth);
  const bool right = this->Has(block + 1, CutNorth);
  const int sides = int(bottom) + int(top) + int(left) + int(right);
  if (sides == 0)
  {
    return;
  }
  const bool isCorner = sides == 2 && bottom != top;
  const unsigned diagonal = isCorner ? unsigned(bottom == left ? FallingLeft : RisingLeft) : 0U;
  this->Add(block, Open | diagonal);
  for (const std::int64_t corner : { block, block + 1, block + this->Width, block + this->Width + 1 })
  {
    this->Add(corner, BesideOpen);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::uint64_t CutBlocks::BesideOpenFrom(std::int64_t place) const
{
  const std::int64_t end = std::min<std::int64_t>(64, std::int64_t(this->Flags.size()) - place);
  std::uint64_t bits = 0;
  for (std::int64_t bit = 0; bit < end; ++bit)
  {
    bits |= std::uint64_t(this->IsBesideOpen(place + bit)) << bit;
  }
  return bits;
}
}
