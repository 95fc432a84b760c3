// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The error within which a mesh passes over the noise of a horizon, where none is given.

#ifndef SeismicHorizonsHeightNoise_h
#define SeismicHorizonsHeightNoise_h

#include "Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The value of a maximum error that stands for one that is chosen.
constexpr double AutomaticError = -1.0;

/// Heights scatter by this much around what a mesh can follow.
struct HeightNoise
{
  double Deviation = 0.0; // standard deviation, in the unit of the heights
  bool IsRounding = false; // steps of heights scatter more than their noise

  /// Few points of normal noise are farther off than three deviations, on both sides of the mesh.
  double MaximumError() const { return 6.0 * this->Deviation; }
};

/// Second differences give the noise along the rougher axis, as interpolated lines are smooth along the other. Rounding
/// is the least difference of neighbours, at most 1, over the root of 12.
HeightNoise MeasureHeightNoise(PlanePoints columns, const std::vector<double>& heights);
}

#endif
