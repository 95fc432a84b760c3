// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFrame.h"

#include "Common/Horizon/PlaneGeometry.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const std::vector<PlanePoint>& places)
{
  // The lowest bit set in any distance from the first place is the largest power of two that divides them all, and
  // all distances from the least coordinates.
  const PlanePoint first = places.front();
  PlaneBox box;
  std::int32_t bits = 0;
  for (const PlanePoint& place : places)
  {
    box.Add(place);
    bits |= (place.X - first.X) | (place.Y - first.Y);
  }
  this->Least = box.Least;
  this->Greatest = box.Greatest;
  while (bits != 0 && ((bits >> this->Shift) & 1) == 0)
  {
    ++this->Shift;
  }
}
}
