// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFrame.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const std::vector<PlanePoint>& places)
  : Least(places.front())
  , Greatest(places.front())
{
  // A power of two that divides all differences from the first place also divides those from the least coordinates. The
  // lowest bit that is set in any of them is the largest such power.
  const PlanePoint first = places.front();
  std::int32_t bits = 0;
  for (const PlanePoint& place : places)
  {
    this->Least = { std::min(this->Least.X, place.X), std::min(this->Least.Y, place.Y) };
    this->Greatest = { std::max(this->Greatest.X, place.X), std::max(this->Greatest.Y, place.Y) };
    bits |= (place.X - first.X) | (place.Y - first.Y);
  }
  while (bits != 0 && ((bits >> this->Shift) & 1) == 0)
  {
    ++this->Shift;
  }
}
}
