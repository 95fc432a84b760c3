// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From fault sticks to traces. A stick runs down a fault surface; the sticks of a fault stand side by side. Where they
// pass through the horizon, one after the other, the fault meets it.

#ifndef SeismicHorizonsFaultSticks_h
#define SeismicHorizonsFaultSticks_h

#include "ColumnHeights.h"
#include "Common/Types.h"
#include "FaultPolylines.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct FaultStick
{
  std::vector<SpacePoint> Places; // in columns and vertical indices
  std::string Fault; // what sticks of one fault have in common
};

/// A polyline through the places where successive sticks of one fault pass through the horizon; a stick that does not
/// ends it. Over gaps in the horizon heights go on evenly along the stick. Throws InputError on a place that is not
/// finite.
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultStick>& sticks);
}

#endif
