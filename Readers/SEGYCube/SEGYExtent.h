// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYExtent_h
#define SeismicHorizonsSEGYExtent_h

#include "SEGYWindow.h"

#include <array>

namespace SeismicHorizons
{
struct SEGYRanges
{
  std::array<int, 2> Inlines = { 0, -1 }; // First and last number; all if the first is larger.
  std::array<int, 2> Crosslines = { 0, -1 };
  std::array<int, 2> Samples = { 0, -1 }; // First and last vertical index; -1 for the last one.
};

CubeExtent FindExtent(const SEGYCube& cube, const SEGYRanges& ranges);
}

#endif
