// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinch-out lines: around areas where two neighbours of a stack have become one. A plan without them has thin feathers
// that reach far beyond the line, as a layer that is thinner than the error is within it.

#ifndef SeismicHorizonsPinchOuts_h
#define SeismicHorizonsPinchOuts_h

#include "Common/Monitor.h"
#include "Common/Types.h"
#include "Crossings.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct PinchOutOptions
{
  /// Areas of fewer columns have no line, and nor have as small ones inside areas: at least 1.
  std::int64_t SmallestPinch = 25;
  /// How far in plan, in columns, the line may be from the columns around the area.
  double Tolerance = 0.0;
  /// And how far the upper horizon may be from it there, in lattice units.
  double MaximumError = 0.0;
};

struct PinchOutLines
{
  /// Points on the outline at which lines begin or end: they have to stay there.
  std::vector<PointId> OnOutline;
  /// Straight lines between points where the layer has no thickness, each with all points of the area's border that it
  /// stands for, its ends first and last. Lines of one layer do not cross, those of two may. Where an area reaches the
  /// outline, that is its border, and there is no line.
  std::vector<std::vector<PointId>> Lines;
};

/// The lines of all layers of an ordered stack. Columns are those of its points, row by row; `isOnLoop` has 1 for those
/// that the outline and loops of holes visit.
PinchOutLines FindPinchOutLines(PlanePoints columns, const HeightStack& heights,
  const std::vector<unsigned char>& isOnLoop, const PinchOutOptions& options, const Monitor& monitor = Monitor());
}

#endif
