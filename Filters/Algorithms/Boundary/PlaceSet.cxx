// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaceSet.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PlaceSet::PlaceSet(const ColumnRaster& raster)
  : Width(raster.Width())
  , Places(raster.Width() * raster.Height())
  , Margin((this->Width / WordBits + 1) * WordBits)
  , Words(std::size_t((2 * this->Margin + this->Places) / WordBits + 4), 0)
{
  std::uint64_t* word = this->Words.data() + this->Margin / WordBits;
  for (std::int64_t place = 0; place < this->Places; place += WordBits, ++word)
  {
    const std::int64_t end = std::min<std::int64_t>(WordBits, this->Places - place);
    for (std::int64_t bit = 0; bit < end; ++bit)
    {
      *word |= std::uint64_t(raster[place + bit] != NoPoint) << bit;
    }
  }
}
}
