// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads the samples of a part of a cube. Files have them trace by trace, and images level by level.

#ifndef SeismicHorizonsSEGYWindow_h
#define SeismicHorizonsSEGYWindow_h

#include "SEGYCube.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// First and last i, j and k, as extents of VTK.
using CubeExtent = std::array<int, 6>;

/// The vertical indices of a column that have samples, up to before the last; none where first and last are the same.
struct SampleRange
{
  int First = 0;
  int End = 0;
};

struct SEGYWindow
{
  std::vector<SampleRange> Columns; // of the extent, i fastest
  bool IsFull = true; // whether all have samples at all levels of the extent
  std::int64_t NotFinite = 0; // samples that are nan or infinite
};

/// Reads the samples of an extent within the cube into `values`, which has room for them, i fastest and k slowest.
/// Where there are none 0 is written; that is on columns without a trace, or with one of zeros only, whichever part of
/// it is asked for. On several threads; memory besides the values is some megabytes for each of them.
SEGYWindow ReadSEGYWindow(
  const SEGYCube& cube, const CubeExtent& extent, float* values, const Monitor& monitor = Monitor());

/// The size that 98 % of the samples stay below, by some traces all over the cube; zeros do not count. 0 where all are
/// 0. Colours that end here show more than those that end at the strongest sample.
float FindStrongAmplitude(const SEGYCube& cube);
}

#endif
