// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The patches of a horizon one by one: their points, their loops, and the sides of the full blocks that are meshed.

#ifndef SeismicHorizonsPatchList_h
#define SeismicHorizonsPatchList_h

#include "Common/BoundedHorizon.h"
#include "Common/CellGrid.h"
#include "Common/CountingSort.h"
#include "Common/PlaneFrame.h"
#include "Common/RawVector.h"
#include "FullBlocks.h"

#include <vector>

namespace SeismicHorizons
{
/// One patch. Its points have numbers of their own, from 0.
struct Patch
{
  std::vector<PointId> Points; // for each of its points the number in the horizon
  std::vector<PlanePoint> Places; // in its frame
  PlaneFrame Frame;
  Loops Boundary;
  std::vector<Edge> BlockSides; // with full blocks to their left, and nothing meshed to their right
};

class PatchList
{
public:
  /// Leaves out the points that blocks cover. `horizon` must outlive the list, and `frame` is that of its points.
  /// Throws InputError on patch numbers that are negative or not less than the number of points.
  PatchList(const BoundedHorizon& horizon, const PlaneFrame& frame, const FullBlocks& blocks);

  /// How many patches there are. Some may have no points.
  std::int64_t Size() const { return this->Patches; }

  /// How many points all patches have.
  std::size_t NumberOfPoints() const { return this->Loose.size(); }

  /// Throws InputError when a loop of the patch leaves it.
  Patch Get(std::int64_t number);

  /// The number that a point of the horizon has in its patch, once Get was called for the patch.
  PointId NumberInPatch(PointId point) const { return this->LocalNumber[std::size_t(point)]; }

private:
  void AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const;

  const BoundedHorizon& Horizon;
  const PlaneFrame Frame;
  const std::int64_t Patches;
  const std::vector<PointId> Loose;
  const PointLists Points;
  const ItemLists<std::size_t> LoopsOf;
  const EdgeLists BlockSides;
  RawVector<PointId> LocalNumber;
};
}

#endif
