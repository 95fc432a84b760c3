// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYExtent_h
#define SeismicHorizonsSEGYExtent_h

#include "SEGYWindow.h"

#include <array>

namespace SeismicHorizons
{
/// The part of a cube that the user asks for.
struct SEGYRanges
{
  std::array<int, 2> Inlines = { 0, -1 }; // first and last number; all where the first is the larger one
  std::array<int, 2> Crosslines = { 0, -1 };
  std::array<int, 2> Samples = { 0, -1 }; // first and last vertical index; -1 for the last there is
};

/// The extent of what is in these ranges. Throws InputError, with the names of the reader's properties, on ranges that
/// cannot be, and where there is nothing in them.
CubeExtent FindExtent(const SEGYCube& cube, const SEGYRanges& ranges);
}

#endif
