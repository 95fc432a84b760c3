// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes horizons with faults whose place and throw are known, for tests and studies of what finds them: a dipping and
// folded surface that is torn along slightly bent lines. The result depends on the options alone.

#ifndef SeismicHorizonsFaultGenerator_h
#define SeismicHorizonsFaultGenerator_h

#include "Common/Horizon/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct FaultGeneratorOptions
{
  int Size = 200; // columns along i and j
  double Dip = 0.5; // vertical indices per column
  double Fold = 0.2; // amplitude of folds 40 columns wide, in parts of the height that the dip gives over these
  double Noise = 0.3; // standard deviation in vertical indices
  bool AreHeightsWhole = true;
  int NumberOfFaults = 4; // side by side
  double Throw = 10.0; // vertical indices; the largest along a fault
  bool AreTapered = false; // whether the throw falls to 0 within the lattice
  bool AreCrossed = false; // by as many others, at an angle
  double RampWidth = 0.0; // columns across a fault over which the surface steps; 0 for a crack
  int PickSpacing = 1; // heights of every so many rows, with straight lines between
  double GapWidth = 0.0; // columns without points along faults
  int HoleSize = 0; // columns along i and j without points, in the middle
  std::uint64_t Seed = 1;
};

/// A link of the lattice that a fault cuts.
struct TornLink
{
  PlanePoint Column;
  bool IsNorth = false; // leads to j + 1, otherwise to i + 1
  double Throw = 0.0; // height beyond it minus height before it, by faults alone
};

struct FaultedHorizon
{
  std::vector<PlanePoint> Columns;
  std::vector<double> Height;
  std::vector<TornLink> Torn; // by j, i and side, whether there are points in the columns or not
};

FaultedHorizon MakeFaultedHorizon(const FaultGeneratorOptions& options);
}

#endif
