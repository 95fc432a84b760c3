// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chooses the smoothing of plates by the roughness of the horizon.

#ifndef SeismicHorizonsPlateChoice_h
#define SeismicHorizonsPlateChoice_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "GapRegion.h"

#include <vector>

namespace SeismicHorizons
{
struct PlateChoice
{
  double RimSmoothing = 1.0;
  int RimWidth = 3;
};

constexpr int WidestChosenRim = 5;

/// The twist z(i, j) - z(i + l, j) - z(i, j + l) + z(i + l, j + l) measures roughness in squares without a cut, by the
/// ratio of its mean squares at l = 2 and l = 1: 1 for white noise, 16 for a smooth surface. Large horizons are
/// sampled.
///  - Above 2.4 there is hardly any noise, and the plate interpolates.
///  - Below 1.4, and if integer heights have twists of rounding alone, it smooths strongly.
///  - Otherwise, and without such squares, it smooths slightly.
PlateChoice ChoosePlate(
  const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts);
}

#endif
