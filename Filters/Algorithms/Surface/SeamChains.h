// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fewer points on the seams of a part of a horizon (Boundary/SeamGaps.h), so that the parts on both sides of one fit.
//
//     P  .  .  Q  .  P  .  .  .  .  P        P    points that stay whatever is beside the seam
//     |_____________|_______________|        Q    a point that this part alone needs, as a loop turns there
//
// Which points stay follows from the row of the seam alone: as few as keep all others within a height tolerance of the
// line between them, gap by gap. A loop of one part may turn at one of those others. It has to stay there, but the
// other part does not know of it; so it is put onto the line, and its edge in the other part can be cut there without a
// change of the surface.

#ifndef SeismicHorizonsSeamChains_h
#define SeismicHorizonsSeamChains_h

#include "Boundary/ExteriorBoundary.h"
#include "Common/DroppedPoints.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// A point that was put onto the line of a seam.
struct SeamPin
{
  PointId Point = NoPoint;
  double Height = 0.0; // lattice units
};

struct SeamChains
{
  /// The loops without the points of seams that were dropped.
  Loops Boundary;
  /// The points of seams that stay.
  std::vector<PointId> Kept;
  /// Each with the nearer one beside it that stays; in no order.
  std::vector<DroppedPoint> Dropped;
  std::vector<SeamPin> Pins;
  /// The points to the left of gaps wider than the radius that this part has no surface beside.
  std::vector<PointId> OpenGaps;
  /// The largest distance in space, in lattice units, from a point to the line of its seam.
  double Deviation = 0.0;
  /// The same upwards.
  double HeightDeviation = 0.0;
};

/// Of a boundary with seams that was found for `options`; `columns` and `height` are those of all points it numbers.
SeamChains SimplifySeams(PlanePoints columns, const std::vector<double>& height, const Loops& boundary,
  const BoundaryOptions& options, double heightTolerance);
}

#endif
