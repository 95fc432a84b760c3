// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaneFrame_h
#define SeismicHorizonsPlaneFrame_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Makes the coordinates of places in the plane small: the least ones become 0, and all are divided by the largest
/// power of two that leaves them whole. When all points are on whole columns, the sub-voxels of a column drop out. The
/// answers of the predicates stay the same.
struct PlaneFrame
{
  PlaneFrame() = default;
  /// For places of which there is at least one.
  explicit PlaneFrame(const std::vector<PlanePoint>& places);

  /// From the coordinates of the places to the small ones.
  PlanePoint Inward(const PlanePoint& place) const
  {
    return { (place.X - this->Least.X) >> this->Shift, (place.Y - this->Least.Y) >> this->Shift };
  }
  /// The other way.
  PlanePoint Outward(const PlanePoint& place) const
  {
    return { (place.X << this->Shift) + this->Least.X, (place.Y << this->Shift) + this->Least.Y };
  }

  PlanePoint Least; // of the places, x and y each on its own
  PlanePoint Greatest;
  int Shift = 0; // the exponent of the power of two
};
}

#endif
