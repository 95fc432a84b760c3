// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which known point is nearest to each column of a gap, for what can not be interpolated.

#ifndef SeismicHorizonsNearestRim_h
#define SeismicHorizonsNearestRim_h

#include "GapRegion.h"

#include <vector>

namespace SeismicHorizons
{
/// By steps to one of four neighbours over links that are not cut; of equally near points that of the lowest number.
/// For each of GapRegion::GapPlaces. Empty when a column of the gap reaches none.
std::vector<PointId> FindNearestRim(const GapRegion& region);
}

#endif
