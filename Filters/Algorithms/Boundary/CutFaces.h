// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which faces of the graph of hops stay open because a faulted link is in them, whatever the sizes of holes that get
// loops.
//
// A faulted link with a point at an end is passed by the sweep of a walk there. When that is the walk around a hole,
// the hole holds the cut: a crack is such a hole, of the open blocks of its links. When it is the walk around the
// outline of a component, the cut is in the hole that the component lies in. So are faulted links between empty
// columns.
//
// The cracks between the loops of a horizon with cuts. Hops across cuts (PlanarHops.h) part what the admissible hops
// leave open there into faces. Those with no more columns inside than a square of hops are cracks; the others are gaps
// of missing points, or the outside. With a radius of 1 no column may be inside: faces of cracks are blocks of four
// points and halves of blocks of three.
//
//     o---o---o---o---o---o       o       points
//     |   :   :   :  /            -, |    admissible hops
//     |   :   :   : /             :, /    hops across cuts: the slanted one is an open end,
//     o---o---o---o                       as a point is missing beside it

#ifndef SeismicHorizonsCutFaces_h
#define SeismicHorizonsCutFaces_h

#include "Common/ColumnIndex.h"
#include "Common/Cracks.h"
#include "Common/Types.h"
#include "CutBlocks.h"
#include "Hops.h"
#include "PatchComponents.h"
#include "PlanarHops.h"

#include <array>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// The components of points that the hops of a graph connect.
PatchComponents FindHopComponents(
  PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const PlanarHops& graph);

class CutFaces
{
public:
  /// Keeps references.
  CutFaces(PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const CutBlocks& blocks);

  /// Takes the walk around the outline of the next component.
  void AddOutline(const std::vector<FaceStep>& steps);

  /// Takes the walk around a hole, and tells whether its loop should be collected. `hasLoop` is for a hole that gets a
  /// loop in any case, and `hasColumns` for one that other faces can lie in.
  bool AddHole(const std::vector<FaceStep>& steps, bool hasLoop, bool hasColumns);

  /// Of the loops that were collected, first those of all outlines, those that stay. `first` has the first place of
  /// each component.
  Loops Select(const Loops& loops, const std::vector<std::int64_t>& first);

private:
  /// A loop that was collected.
  struct Face
  {
    std::int64_t TwiceArea;
    bool Stays;
  };

  bool PassesCut(const std::vector<FaceStep>& steps) const;
  bool IsSwept(HopId hop, HopId from, HopId to) const;
  std::vector<std::int64_t> PlacesInOpenFaces(const std::vector<std::int64_t>& first) const;

  const PlanePoints Columns;
  const ColumnIndex& Index;
  const HopVectors& Hops;
  const CutBlocks& Blocks;
  std::array<HopId, 4> Sides; // the hops along links
  std::vector<Face> Faces; // in the order of the loops
  std::vector<std::size_t> CutOutlines; // of components, that cuts are at
};

/// A side of a face, with the face to its left.
struct CrackSide
{
  enum class Kind : unsigned char
  {
    Cutoff, // an admissible hop
    Short, // a hop to a neighbour across a cut
    Long // a longer one: what it leads over may have no cut in it
  };

  PointId From;
  PointId To;
  std::int32_t Face;
  Kind What;
};

/// The sides of all faces of cracks, face by face. Takes time for the faces beside hops across cuts.
std::vector<CrackSide> FindCrackFaces(
  PlanePoints columns, const ColumnIndex& index, const HopVectors& hops, const PlanarHops& graph);

/// What of them is open between some loops. Points without a patch are missing.
Cracks FindCracks(std::vector<CrackSide> sides, const Loops& boundary, const std::vector<std::int32_t>& patches);
}

#endif
