// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polygons of faults: closed lines around the gap that a fault leaves in a horizon. Mapping programs draw them, and
// fill their inside with values that nobody has seen.

#ifndef SeismicHorizonsFaultPolygons_h
#define SeismicHorizonsFaultPolygons_h

#include "Common/KeptPoints.h"
#include "Common/Types.h"
#include "FaultLines.h"

#include <vector>

namespace SeismicHorizons
{
/// Whether a line ends where it began, and has an inside.
bool IsClosed(const FaultPolyline& line);

/// The points that no closed line has inside, by the even-odd rule for each of them; open lines have none. n log n in
/// the points, and in how often lines cross rows of the lattice that have points. Throws InputError when that is more
/// than a hundred million times.
KeptPoints FindOutside(PlanePoints columns, const std::vector<FaultPolyline>& lines);
}

#endif
