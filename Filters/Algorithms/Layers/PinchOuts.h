// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch-out lines, around areas where two neighbours of a stack have become one. Without these lines layers end in thin
// feathers far beyond them, which are within the error.

#ifndef SeismicHorizonsPinchOuts_h
#define SeismicHorizonsPinchOuts_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Crossings.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct PinchOutOptions
{
  std::int64_t SmallestPinch = 25; // columns of areas with lines, and of holes in them: at least 1
  double Tolerance = 0.0; // from the line to the columns around the area in plan, in columns
  double MaximumError = 0.0; // from the line to the upper horizon, in lattice units
};

struct PinchOutLines
{
  std::vector<PointId> OnOutline; // ends of lines, which have to stay on the outline
  /// Each with all points of the border that it replaces. Lines of different layers may cross.
  std::vector<std::vector<PointId>> Lines;
};

/// Columns are row by row; `isOnLoop` has 1 for points of outlines.
PinchOutLines FindPinchOutLines(PlanePoints columns, const HeightStack& heights,
  const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options, const Monitor& monitor = Monitor());
}

#endif
