// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The closed surface of a layer: top, base, and walls along the outline and faults, around its cells.
//
// Where a layer pinches out, top and base coincide. The surface is a manifold if
//
//    - a vertex without thickness amid cells stays two points: the layer is pierced there;
//    - one at the border of the cells is one point, and so are others that edges without thickness connect with it;
//    - a vertex has separate points for each sector between such edges, where top and base meet, and the border.

#ifndef SeismicHorizonsLayerBody_h
#define SeismicHorizonsLayerBody_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "LayerPlan.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
enum class BodyFace : unsigned char
{
  Top = 0,
  Base = 1,
  Outline = 2,
  Fault = 3
};

/// A closed manifold of any number of components, which may touch at points and edges.
struct LayerBody
{
  std::vector<PointId> Vertices; // the vertex of the plan, by point
  std::vector<double> Heights;
  /// Counter-clockwise from outside if x, y and heights upwards are right-handed.
  RawVector<PointId> Triangles;
  std::vector<BodyFace> Faces; // by triangle
};

/// Empty if the layer has no cell.
LayerBody MakeLayerBody(const LayerPlan& plan, std::size_t layer, const Monitor& monitor = Monitor());
}

#endif
