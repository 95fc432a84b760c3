// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the points that stand for leaves.
//
// What stands for the inner points of a leaf is their barycentre when that is wanted, lies strictly inside the boundary
// and is alone in its place. Else it is the inner point that is nearest to the barycentre in plan: inner points of a
// horizon lie strictly inside its boundary, and no two of them share a place.

#ifndef SeismicHorizonsStandIns_h
#define SeismicHorizonsStandIns_h

#include "CellLeaves.h"
#include "CellOptions.h"
#include "Common/CellGrid.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// What stands for the inner points of a leaf.
struct StandIn
{
  // The leaf.
  const PointId* First = nullptr;
  const PointId* Last = nullptr;
  // Its place: sub-voxels in plan, lattice units upwards.
  PlanePoint Plane;
  double Height = 0.0;
  PointId Nearest = NoPoint; // the inner point nearest to the barycentre; of several the first one
  bool Averaged = false; // whether it is the barycentre, or Nearest
};

/// Any number of threads may use it at the same time.
class StandInFinder
{
public:
  /// Keeps a reference to `leaves`.
  StandInFinder(const CellLeaves& leaves, RepresentativeKind representative);

  /// For a leaf with an inner point, in a cell of the grid.
  StandIn Find(std::int64_t cell, const PointId* first, const PointId* last) const;

  /// Gives each of the stand-ins of a cell a place of its own. `places` is memory to work with.
  void SeparatePlaces(std::vector<StandIn>& standIns, std::vector<PlanePoint>& places) const;

private:
  StandIn FindBarycentre(const PointId* first, const PointId* last) const;
  bool IsInside(std::int64_t cell, const PlanePoint& place, PointId inner) const;
  void UseNearest(StandIn& standIn) const;

  const CellLeaves& Leaves;
  const EdgeLists Edges; // the boundary edges that cross each cell
  const RepresentativeKind Representative;
};
}

#endif
