// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deals the points and the loops of a horizon out to its patches.

#ifndef SeismicHorizonsPatchList_h
#define SeismicHorizonsPatchList_h

#include "BoundedHorizon.h"
#include "CellGrid.h"

#include <vector>

namespace SeismicHorizons
{
/// Where normalised places were before: (place << Shift) + Origin.
struct Frame
{
  PlanePoint Origin;
  int Shift = 0;
};

/// Moves the places to the origin and drops the power of two they share, so that on whole columns numbers are as small
/// as the patch is. Neither changes any answer of the predicates.
Frame Normalise(std::vector<PlanePoint>& places);

/// One patch with numbers of its own for its points.
struct Patch
{
  std::vector<PointId> Points; // for each of its points the number in the horizon
  std::vector<PlanePoint> Places;
  Frame PlacesFrame;
  Loops Boundary;
};

class PatchList
{
public:
  /// `horizon` must outlive the list. Throws InputError on patch numbers that are negative or not less than the number
  /// of points.
  explicit PatchList(const BoundedHorizon& horizon);

  /// Some patches may have no points.
  std::int64_t Size() const { return this->Patches; }

  /// A patch with normalised places. Throws InputError when one of its loops leaves it.
  Patch Get(std::int64_t number);

private:
  void AddLoop(std::size_t loop, std::int32_t number, Patch& patch) const;

  const BoundedHorizon& Horizon;
  const std::int64_t Patches;
  const PointLists Points;
  const CellLists<std::size_t> LoopsOf;
  std::vector<PointId> LocalNumber; // of the points of patches that were asked for already
};
}

#endif
