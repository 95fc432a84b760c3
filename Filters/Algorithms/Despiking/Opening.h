// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The morphological opening of a horizon by a square.

#ifndef SeismicHorizonsOpening_h
#define SeismicHorizonsOpening_h

#include "Boundary/ColumnRaster.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The points that no full square of width + 1 columns along each side covers. Takes time linear in the places of the
/// raster, whatever the width is.
std::vector<PointId> FindThreads(const ColumnRaster& raster, int width);
}

#endif
