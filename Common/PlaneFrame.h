// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaneFrame_h
#define SeismicHorizonsPlaneFrame_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Coordinates of places in the plane that are as small as can be: counted from the least ones, and divided by the
/// largest power of two that divides all of them. Points on whole columns get the numbers of the columns in this way,
/// however many sub-voxels a column has. The predicates give the same answers before and after, as they do not depend
/// on where the origin is and how long a unit.
struct PlaneFrame
{
  PlaneFrame() = default;
  /// Of places of which there is at least one.
  explicit PlaneFrame(const std::vector<PlanePoint>& places);

  /// From the places that the frame was made for to its own.
  PlanePoint Inward(const PlanePoint& place) const
  {
    return { (place.X - this->Least.X) >> this->Shift, (place.Y - this->Least.Y) >> this->Shift };
  }
  /// And back.
  PlanePoint Outward(const PlanePoint& place) const
  {
    return { (place.X << this->Shift) + this->Least.X, (place.Y << this->Shift) + this->Least.Y };
  }

  PlanePoint Least; // of the places, as they were
  PlanePoint Greatest;
  int Shift = 0; // the exponent of the power of two
};
}

#endif
