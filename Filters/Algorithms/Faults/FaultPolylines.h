// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cuts along lines that are given: fault traces of an interpreter, or polygons around the gaps of faults.
//
// A link is cut where a line passes between its two columns, so that columns are parted just as the line parts them,
// and the cuts are a chain without gaps. Of a polygon, which goes along both lips of a fault, both are cut: there is no
// surface between them, and what is filled in later goes on from each lip alone. Where a polygon is narrower than a
// column, both lips cut the same links.
//
// A line exactly through a column passes on the side of lesser coordinates, as its places are rounded down.

#ifndef SeismicHorizonsFaultPolylines_h
#define SeismicHorizonsFaultPolylines_h

#include "ColumnHeights.h"
#include "FaultLines.h"

#include <vector>

namespace SeismicHorizons
{
/// A place on the map, in columns.
struct MapPlace
{
  double X = 0.0;
  double Y = 0.0;
};

using FaultPolyline = std::vector<MapPlace>;

/// The links of the horizon's bounding box that polylines cut: a line for each part of a polyline inside the box, with
/// the throw where both columns of a link have points. Throws InputError on a place that is not finite, and on
/// lines that go to and fro until they have cut far more links than there are. Linear in the number of places and of
/// links that are cut.
FaultLines CutAlong(const ColumnHeights& heights, const std::vector<FaultPolyline>& polylines);
}

#endif
