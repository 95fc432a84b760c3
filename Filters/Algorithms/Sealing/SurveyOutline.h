// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The outline of picks on the map, for walls: few corners, without holes, and without bays and spurs a few columns wide.

#ifndef SeismicHorizonsSurveyOutline_h
#define SeismicHorizonsSurveyOutline_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "SealedModel.h"

#include <vector>

namespace SeismicHorizons
{
/// Around the largest patch of columns of the box where at least one horizon has picks; clockwise. Throws InputError if it is
/// no area.
std::vector<PlanePoint> FindSurveyOutline(const SealingInput& input, const Monitor& monitor = Monitor());
}

#endif
