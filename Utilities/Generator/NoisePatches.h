// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a synthetic horizon is rough: patches in which every height is off by a random amount, and voxels are missing
// at random, as where a reflection is weak.

#ifndef SeismicHorizonsNoisePatches_h
#define SeismicHorizonsNoisePatches_h

#include "HorizonGeneratorOptions.h"
#include "RandomFields.h"

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
class NoisePatches
{
public:
  NoisePatches(const HorizonGeneratorOptions& options, std::uint64_t seed)
    : Part(options.NoiseFraction)
    , Height(options.NoiseHeight)
    , Gaps(options.NoiseGaps)
    , Seed(seed)
  {
  }

  /// How far the voxel of a column is off, up or down, in cells; 0 outside of patches.
  double Offset(int i, int j) const
  {
    return this->Contains(i, j) ? this->Height * (2.0 * Random(SeedOf(this->Seed, Field::NoiseHeight), i, j) - 1.0)
                                : 0.0;
  }

  /// Whether the voxel of a column is missing.
  bool IsGap(int i, int j) const
  {
    return this->Contains(i, j) && Random(SeedOf(this->Seed, Field::NoiseGap), i, j) < this->Gaps;
  }

private:
  /// Blocks of columns, of which each is rough with the same probability, so that patches take the part of the area
  /// that was asked for, wherever they are. Their sides are bent.
  bool Contains(int i, int j) const
  {
    constexpr double block = 16.0; // columns
    constexpr double bend = 0.4; // of a block
    if (this->Part <= 0.0)
    {
      return false;
    }
    const std::uint64_t seed = SeedOf(this->Seed, Field::NoisePatch);
    const double x = i / block;
    const double y = j / block;
    const double column = std::floor(x + bend * Noise(Mix(seed), 2.0 * x, 2.0 * y));
    const double row = std::floor(y + bend * Noise(Mix(seed + 1), 2.0 * x, 2.0 * y));
    return Random(seed, static_cast<std::int64_t>(column), static_cast<std::int64_t>(row)) < this->Part;
  }

  double Part;
  double Height;
  double Gaps;
  std::uint64_t Seed;
};
}

#endif
