// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The closed surface of a layer: its top, its base, and walls along the outline and along faults, over the triangles of
// the plan where it has a cell.
//
// Where a layer pinches out, top and base have the same place, and whether they are one point there decides whether the
// surface is a manifold. Seen from above, of the triangles with a cell:
//
//    - a vertex without thickness where no triangle is missing around it, as at a single column, stays two points: the
//      layer is pierced there, and goes on around it
//    - one beside a missing triangle or the outline is one point: top and base meet along the edges between such points
//    - an edge between two vertices without thickness, of which one is one point, parts the layer: both its sides get
//      points of their own, and top and base meet on either. So its other end is one point as well, and so on
//    - a vertex has points of its own for each sector that such edges, missing triangles and the outline leave around
//      it.

#ifndef SeismicHorizonsLayerBody_h
#define SeismicHorizonsLayerBody_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "LayerPlan.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// What a triangle of a body is part of.
enum class BodyFace : unsigned char
{
  Top = 0,
  Base = 1,
  Outline = 2,
  Fault = 3
};

/// A closed manifold of one component or more, which may touch itself and others at points and edges.
struct LayerBody
{
  std::vector<PointId> Vertices; // of the plan, by point
  std::vector<double> Heights;
  /// Three points each, counter-clockwise seen from outside where x, y and heights, upwards, are right-handed.
  RawVector<PointId> Triangles;
  std::vector<BodyFace> Faces; // by triangle
};

/// Empty where the layer has no cell.
LayerBody MakeLayerBody(const LayerPlan& plan, std::size_t layer, const Monitor& monitor = Monitor());
}

#endif
