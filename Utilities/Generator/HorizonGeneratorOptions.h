// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What synthetic horizons are like.

#ifndef SeismicHorizonsHorizonGeneratorOptions_h
#define SeismicHorizonsHorizonGeneratorOptions_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <cstdint>
#include <string>

namespace SeismicHorizons
{
struct HorizonGeneratorOptions
{
  std::uint64_t Seed = 1;
  /// Cells of the lattice; nZ at least five times the number of horizons.
  SparseMatrixSize Size = { 240, 200, 120 };
  /// Their surface IDs are 1, 2, ... from the top down.
  int NumberOfHorizons = 3;
  /// Holes in each horizon.
  int NumberOfHoles = 8;
  /// Islands of each horizon: parts that touch no other part of it. The first lies in the large hole, the others
  /// outside or, where there is no room, in holes of their own.
  int NumberOfIslands = 3;
  /// Part of the voxels that are missing one by one, with all eight neighbours left in place: 0 to 0.1.
  double DropoutFraction = 0.02;
  /// The shape of the outline before lobes and bays bend it, which is how full the bounding box gets: from -1 (a star
  /// with four points) over 0 (a circle) to 1 (a square).
  double Squareness = 0.0;
  /// Part of the area in patches of noise, 0 to 1: there heights are off by up to so many cells, up and down, and that
  /// part of the voxels is missing, 0 to below 1.
  double NoiseFraction = 0.0;
  double NoiseHeight = 3.0;
  double NoiseGaps = 0.5;
};

/// What the depth of the lattice leaves to each horizon beside the folds that all share, in cells. A horizon takes half
/// of that, but for its noise.
double ShareOfDepth(const HorizonGeneratorOptions& options);

/// Throws InputError when an option is out of range.
void CheckOptions(const HorizonGeneratorOptions& options);

/// Throws InputError with both texts when a condition is not met.
void Require(bool condition, const std::string& found, const std::string& expected);
}

#endif
