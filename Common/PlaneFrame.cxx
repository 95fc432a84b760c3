// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFrame.h"

#include "PlaneGeometry.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const std::vector<PlanePoint>& places)
{
  // A power of two that divides all distances from the first place also divides those from the least coordinates. The
  // lowest bit that is set in any of them is the largest such power.
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
