// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point sets on a small lattice that are hard on boundaries and meshes, as columns in a random order.

#ifndef SeismicHorizonsPatches_h
#define SeismicHorizonsPatches_h

#include "Common/Horizon/Types.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Patches
{
/// A small random number generator that is the same everywhere.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }

  /// From 0 to below `bound`.
  int Below(int bound) { return int(this->Next() % std::uint64_t(bound)); }
  /// From 0 to below 1.
  double Fraction() { return double(this->Next() >> 11) / 9007199254740992.0; }
  bool Chance(double probability) { return this->Fraction() < probability; }

private:
  std::uint64_t Next();

  std::uint64_t State;
};

using Columns = std::vector<SeismicHorizons::PlanePoint>;

enum class Shape
{
  Sparse,
  Solid,
  Blob,
  Comb,
  Spiral,
  Spurs,
  Pinched,
  Checkerboard,
  Rings,
  SinglePoint,
  Count
};

/// A random set of that kind with at least one point.
Columns Make(Shape shape, Random& random);

/// The columns that are marked with `#` in a picture whose last row is y = 0, in the order of the rows from there.
Columns FromPicture(const std::vector<std::string>& rows);
}

#endif
