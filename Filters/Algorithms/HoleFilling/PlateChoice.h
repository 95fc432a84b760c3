// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much plates over the gaps of a horizon smooth, by how rough it is.

#ifndef SeismicHorizonsPlateChoice_h
#define SeismicHorizonsPlateChoice_h

#include "Common/ColumnIndex.h"
#include "Common/LinkCuts.h"
#include "GapRegion.h"

#include <vector>

namespace SeismicHorizons
{
struct PlateChoice
{
  double RimSmoothing = 1.0;
  int RimWidth = 3;
};

/// The widest rim of any choice.
constexpr int WidestChosenRim = 5;

/// By the twists z(i, j) - z(i + l, j) - z(i, j + l) + z(i + l, j + l) of the squares without a cut: how much larger
/// their mean square is at l = 2 than at l = 1. It is 1 of white noise, whose squares do not grow, and 16 of a smooth
/// surface.
///  - Above 2.4 there is hardly any noise: a plate goes through all heights.
///  - Below 1.4, and where whole heights have no twists but those of rounding, it smooths much.
///  - Else, and where there are no such squares, it smooths a little.
/// Of many columns a part is looked at.
PlateChoice ChoosePlate(
  const ColumnIndex& index, const RasterFrame& frame, const std::vector<double>& heights, const LinkCuts* cuts);
}

#endif
