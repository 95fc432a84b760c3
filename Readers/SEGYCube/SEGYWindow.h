// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files store samples by traces, images by levels.

#ifndef SeismicHorizonsSEGYWindow_h
#define SeismicHorizonsSEGYWindow_h

#include "SEGYCube.h"
#include "SEGYTraces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct SEGYRanges
{
  std::array<int, 2> Inlines = { 0, -1 }; // First and last number; all if the first is larger.
  std::array<int, 2> Crosslines = { 0, -1 };
  std::array<int, 2> Samples = { 0, -1 }; // First and last vertical index; -1 for the last one.
};

CubeExtent FindExtent(const SEGYCube& cube, const SEGYRanges& ranges);

struct SEGYWindow
{
  std::vector<SampleRange> Columns; // i fastest.
  bool IsFull = true; // All columns have samples at all levels.
  std::int64_t Nulls = 0; // samples of 1e30 or more, or nan, in all of the traces
};

/// `values` is ordered with i fastest and k slowest. Samples outside traces are 0, nulls nan; a trace of zeros counts as
/// missing, whichever window is read. Each thread needs some megabytes.
SEGYWindow ReadSEGYWindow(
  const SEGYCube& cube, const CubeExtent& extent, float* values, const Monitor& monitor = Monitor());

/// Returns the amplitude that 98 % of the nonzero samples do not exceed, by some traces. Colours that end there show
/// more than with the strongest sample.
float FindStrongAmplitude(const SEGYCube& cube);
}

#endif
