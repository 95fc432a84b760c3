// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deals what is left to mesh of a horizon, and its loops, out to its patches.

#ifndef SeismicHorizonsPatchList_h
#define SeismicHorizonsPatchList_h

#include "Common/BoundedHorizon.h"
#include "Common/CellGrid.h"
#include "Common/PlaneFrame.h"
#include "Common/RawVector.h"
#include "FullBlocks.h"

#include <vector>

namespace SeismicHorizons
{
/// One patch with numbers of its own for its points.
struct Patch
{
  std::vector<PointId> Points; // for each of its points the number in the horizon
  std::vector<PlanePoint> Places; // in its frame
  PlaneFrame Frame;
  Loops Boundary;
  std::vector<BoundaryEdge> BlockSides; // full blocks are to their left
};

class PatchList
{
public:
  /// Without the points that blocks cover. `horizon` must outlive the list, `frame` is that of its points. Throws
  /// InputError on patch numbers that are negative or not less than the number of points.
  PatchList(const BoundedHorizon& horizon, const PlaneFrame& frame, const FullBlocks& blocks);

  /// Some patches may have no points.
  std::int64_t Size() const { return this->Patches; }

  /// How many points all patches have.
  std::size_t NumberOfPoints() const { return this->Loose.size(); }

  /// Throws InputError when a loop of the patch leaves it.
  Patch Get(std::int64_t number);

  /// The number that a point of the horizon has in its patch, once that was asked for.
  PointId NumberInPatch(PointId point) const { return this->LocalNumber[std::size_t(point)]; }

private:
  void AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const;

  const BoundedHorizon& Horizon;
  const PlaneFrame Frame;
  const std::int64_t Patches;
  const std::vector<PointId> Loose;
  const PointLists Points;
  const CellLists<std::size_t> LoopsOf;
  const EdgeLists BlockSides;
  RawVector<PointId> LocalNumber;
};
}

#endif
