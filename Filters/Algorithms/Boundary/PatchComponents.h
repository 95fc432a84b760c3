// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connected components of a horizon, where points at most k columns apart along each axis are connected (SN_k
// components of the thesis), the components that are islands inside other outlines, and faces at cuts.

#ifndef SeismicHorizonsPatchComponents_h
#define SeismicHorizonsPatchComponents_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/Cracks.h"
#include "Common/Horizon/Types.h"
#include "PlanarHops.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
struct PatchComponents
{
  std::vector<std::int32_t> Component; // by point, numbered row by row from the least y
  std::vector<std::int64_t> First; // places of first points, by component
};

PatchComponents FindPatchComponents(const ColumnIndex& index, std::size_t points, int radius);

/// Components are connected by admissible hops, which cuts leave out.
PatchComponents FindHopComponents(
  const ColumnIndex& index, std::size_t points, const HopVectors& hops, const PlanarHops& graph);

/// Calls visit(n, loops around place n). Places must be sorted, and no loop may pass over a place, except the loop that
/// begins there.
void ForEachPlaceInLoops(PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& places,
  const Loops& loops, const std::function<void(std::size_t, const std::vector<std::size_t>&)>& visit);

/// Assigns each component to the patch whose outline surrounds it, or to itself, also if it is in a hole with a loop.
/// `loops` holds the outlines of all components, then holes, none crossing.
std::vector<std::int32_t> AssignIslands(
  PlanePoints columns, const ColumnIndex& index, const std::vector<std::int64_t>& first, const Loops& loops);

// Faces of the graph of hops that stay open because they hold a faulted link, regardless of the size limits of holes.
//
// A walk sweeps past each faulted link that has a point at an end. The walk around a hole thus finds the cuts in the
// hole. Cuts on the walk around a component lie in the hole that surrounds it, like links between empty columns.
//
// Hops across cuts (PlanarHops.h) divide open areas into faces. Faces with at most (k - 1)^2 columns inside are cracks;
// larger faces are missing columns or the outside. For k = 1, crack faces are blocks of four points or half blocks of
// three.
//
//     o---o---o---o---o---o       o       points
//     |   :   :   :  /            -, |    admissible hops
//     |   :   :   : /             :, /    hops across cuts: the slanted one is an open end,
//     o---o---o---o                       as a point is missing beside it

class CutFaces
{
public:
  CutFaces(PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const CutBlocks& blocks);

  /// Outlines must be added in the order of the components, before any hole.
  void AddOutline(const std::vector<FaceStep>& steps);

  /// Returns whether to collect the loop. `hasLoop`: the hole gets one in any case; `hasColumns`: faces may lie inside.
  bool AddHole(const std::vector<FaceStep>& steps, bool hasLoop, bool hasColumns);

  /// `loops` must hold all collected loops, and `first` the first place of each component.
  Loops Select(const Loops& loops, const std::vector<std::int64_t>& first);

private:
  struct Face
  {
    std::int64_t TwiceArea;
    bool Stays;
  };

  bool PassesCut(const std::vector<FaceStep>& steps) const;
  std::vector<std::int64_t> PlacesInOpenFaces(const std::vector<std::int64_t>& first) const;

  const PlanePoints Columns;
  const ColumnIndex& Index;
  const HopVectors& Hops;
  const CutBlocks& Blocks;
  std::array<HopId, 4> Sides; // hops along links
  std::vector<Face> Faces; // by collected loop
  std::vector<std::size_t> CutOutlines; // components with cuts on their outlines
};

/// The face lies to the left of the side.
struct CrackSide
{
  enum class Kind : unsigned char
  {
    Cutoff, // The hop is admissible.
    Short, // The hop leads to a neighbour across a cut.
    Long // The hop is longer: it touches an open block, but does not always cross a cut.
  };

  PointId From;
  PointId To;
  std::int32_t Face;
  Kind What;
};

std::vector<CrackSide> FindCrackFaces(
  PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const PlanarHops& graph);

/// Returns cracks that the loops leave open. A face with a corner in no patch is no crack.
Cracks FindCracks(std::vector<CrackSide> sides, const Loops& boundary, const std::vector<std::int32_t>& patches);
}

#endif
