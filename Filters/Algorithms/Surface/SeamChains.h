// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simplifies the seams of a part of a horizon (Boundary/SeamGaps.h), so that neighbouring parts fit.
//
//     P  .  .  Q  .  P  .  .  .  .  P        P    nodes, kept by both parts
//     |_____________|_______________|        Q    a pin, where a loop of this part turns
//
// Nodes follow from the row alone: the fewest within a height tolerance, gap by gap. The other part does not know pins,
// so they move onto the line, where its edge can be split without changing the surface.

#ifndef SeismicHorizonsSeamChains_h
#define SeismicHorizonsSeamChains_h

#include "Common/Horizon/DroppedPoints.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"

#include <vector>

namespace SeismicHorizons
{
struct SeamPin
{
  PointId Point = NoPoint;
  double Height = 0.0; // lattice units
};

struct SeamChains
{
  Loops Boundary;
  std::vector<PointId> Kept;
  /// Each comes with the nearer kept point, in no order.
  std::vector<DroppedPoint> Dropped;
  std::vector<SeamPin> Pins;
  /// Gaps are wider than the radius, have no surface beside them, and are given by the point to their left.
  std::vector<PointId> OpenGaps;
  double Deviation = 0.0; // in space, lattice units
  double HeightDeviation = 0.0; // the same vertically
};

/// The boundary must have been found with `options`.
SeamChains SimplifySeams(PlanePoints columns, const std::vector<double>& height, const Loops& boundary,
  const BoundaryOptions& options, double heightTolerance);
}

#endif
