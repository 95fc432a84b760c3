// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cracks between the loops of a horizon with cuts. Hops across cuts (PlanarHops.h) part what the admissible hops
// leave open there into faces. Those with no more columns inside than a square of hops are cracks; the others are gaps
// of missing points, or the outside. With a radius of 1 no column may be inside: faces of cracks are blocks of four
// points and halves of blocks of three.
//
//     o---o---o---o---o---o       o       points
//     |   :   :   :  /            -, |    admissible hops
//     |   :   :   : /             :, /    hops across cuts: the slanted one is a mouth, as a point is missing beside it
//     o---o---o---o

#ifndef SeismicHorizonsCrackFaces_h
#define SeismicHorizonsCrackFaces_h

#include "ColumnRaster.h"
#include "Common/Cracks.h"
#include "Common/Types.h"
#include "HopVectors.h"
#include "PlanarHops.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// A side of a face, with the face to its left.
struct CrackSide
{
  enum class Kind : unsigned char
  {
    Lip, // an admissible hop
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
  const std::vector<PlanePoint>& columns, const ColumnRaster& raster, const HopVectors& hops, const PlanarHops& graph);

/// What of them is open between some loops. Points without a patch are missing.
Cracks FindCracks(std::vector<CrackSide> sides, const Loops& boundary, const std::vector<std::int32_t>& patches);
}

#endif
