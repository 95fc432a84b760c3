// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaneFrame_h
#define SeismicHorizonsPlaneFrame_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Small coordinates from 0 for places in the plane: without the least ones, and without the power of two that all
/// share, so that whole columns have the numbers of columns whatever sub-voxels there are. Neither changes any answer
/// of the predicates.
struct PlaneFrame
{
  PlaneFrame() = default;
  /// For places of which there is at least one.
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
  int Shift = 0;
};
}

#endif
