// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The method of the example: it knows nothing of VTK, and can be tested without it.

#ifndef Smoothing_h
#define Smoothing_h

#include <Common/Base/Monitor.h>

#include <array>
#include <vector>

/// The mean of the heights of the points in the square of columns around each point, `radius` columns along each axis.
/// `columns` and `heights` have an entry for each point, no two points in one column (InputError). Takes time linear in
/// the points and in the square of the radius.
std::vector<double> SmoothHeights(const std::vector<std::array<int, 2>>& columns, const std::vector<double>& heights,
  int radius, const SeismicHorizons::Monitor& monitor = SeismicHorizons::Monitor());

#endif
