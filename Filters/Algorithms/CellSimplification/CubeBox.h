// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The places and the sizes of the cubes of the elaborate simplification and of their octants.

#ifndef SeismicHorizonsCubeBox_h
#define SeismicHorizonsCubeBox_h

#include "Common/Types.h"

#include <cstdint>

namespace SeismicHorizons
{
/// The sizes of some cells, of which the mean is taken.
struct CellSizes
{
  double Sum = 0.0; // in units of the smallest size that halving can give: sums of sizes of leaves are exact
  std::int64_t Number = 0;

  double Mean() const { return this->Sum / double(this->Number); }

  void Add(const CellSizes& other)
  {
    this->Sum += other.Sum;
    this->Number += other.Number;
  }
};

/// A cube, or an octant of one: its least corner and its side. Its own octants begin at the middle.
struct CubeBox
{
  std::int64_t X = 0; // sub-voxels
  std::int64_t Y = 0;
  double Z = 0.0; // lattice units
  std::int64_t PlaneSize = 0; // the side in sub-voxels
  double Size = 0.0; // the side in lattice units

  /// In which octant a place is, 0 to 7.
  int OctantOf(const PlanePoint& place, double height) const
  {
    const std::int64_t half = this->PlaneSize / 2;
    return int(place.X - this->X >= half) + 2 * int(place.Y - this->Y >= half) +
      4 * int(height - this->Z >= 0.5 * this->Size);
  }

  CubeBox Octant(int octant) const
  {
    CubeBox result(*this);
    result.PlaneSize = this->PlaneSize / 2;
    result.Size = 0.5 * this->Size;
    result.X += (octant & 1) ? result.PlaneSize : 0;
    result.Y += (octant & 2) ? result.PlaneSize : 0;
    result.Z += (octant & 4) ? result.Size : 0.0;
    return result;
  }
};
}

#endif
