// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaneFrame_h
#define SeismicHorizonsPlaneFrame_h

#include "Common/Horizon/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Reduces coordinates to the smallest integers: relative to the least, and divided by the largest common power of two.
/// Predicates do not depend on origin and unit.
struct PlaneFrame
{
  PlaneFrame() = default;
  explicit PlaneFrame(const std::vector<PlanePoint>& places);

  PlanePoint Inward(const PlanePoint& place) const
  {
    return { (place.X - this->Least.X) >> this->Shift, (place.Y - this->Least.Y) >> this->Shift };
  }
  PlanePoint Outward(const PlanePoint& place) const
  {
    return { (place.X << this->Shift) + this->Least.X, (place.Y << this->Shift) + this->Least.Y };
  }

  PlanePoint Least;
  PlanePoint Greatest;
  int Shift = 0; // exponent of the power of two
};
}

#endif
