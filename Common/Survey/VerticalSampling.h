// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vertical indices for horizons that come with z alone. The thresholds of the stages are in lattice units, of which the
// vertical step is one, so that there has to be one.

#ifndef SeismicHorizonsVerticalSampling_h
#define SeismicHorizonsVerticalSampling_h

#include "Common/LatticeHorizon.h"
#include "Common/Monitor.h"

#include <vector>

namespace SeismicHorizons
{
struct VerticalSampling
{
  double First = 0.0; // z of vertical index 0
  double Step = 1.0; // from an index to the next, in the unit of z
  int Indices = 1;
};

/// One for each horizon: from a multiple of the step, at most the least z, up to the largest. A step that is given
/// makes one for all of them, by which they can be compared. Where it is 0, each gets one that suits its own data, so
/// that errors in steps are the same with and without others in the file: the median of the differences between
/// neighbouring columns that have different z, rounded to the nearest of 1, 2 and 5 times a power of ten; 1 where there
/// are none. Throws InputError on a step that is negative or not finite, and on one that makes 2^31 indices or more.
std::vector<VerticalSampling> FindVerticalSamplings(
  const std::vector<LatticeHorizon>& horizons, double step, const Monitor& monitor = Monitor());
}

#endif
