// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vertical indices for horizons with z alone. The vertical step is the unit of thresholds.
//
// Without a given step each horizon gets its own, which does not depend on others in the file: the median difference
// between neighbouring columns of different z, rounded to 1, 2 or 5 times a power of ten, or 1.

#ifndef SeismicHorizonsVerticalSampling_h
#define SeismicHorizonsVerticalSampling_h

#include "Common/Base/Monitor.h"
#include "LatticeHorizon.h"

#include <vector>

namespace SeismicHorizons
{
struct VerticalSampling
{
  double First = 0.0; // z of vertical index 0.
  double Step = 1.0; // In the unit of z.
  int Indices = 1;
};

/// Samplings start at a multiple of the step, at most the least z. A given step applies to all horizons. Throws
/// InputError for an invalid step, and for 2^31 indices or more.
std::vector<VerticalSampling> FindVerticalSamplings(
  const std::vector<LatticeHorizon>& horizons, double step, const Monitor& monitor = Monitor());
}

#endif
