// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault polygons are closed lines around the area that a fault leaves empty in a horizon. Mapping programs fill their
// inside with values that are not data.

#ifndef SeismicHorizonsFaultPolygons_h
#define SeismicHorizonsFaultPolygons_h

#include "Common/Horizon/KeptPoints.h"
#include "Common/Horizon/Types.h"
#include "FaultLines.h"

#include <vector>

namespace SeismicHorizons
{
/// A closed line ends where it began and has an inside.
bool IsClosed(const FaultPolyline& line);

/// Returns the points outside all closed lines, by the even-odd rule for each line. Throws InputError for more than a
/// hundred million crossings of rows.
KeptPoints FindOutside(PlanePoints columns, const std::vector<FaultPolyline>& lines);
}

#endif
