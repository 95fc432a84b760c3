// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Petrel writes depth and time as negative numbers, other programs as positive numbers.

#ifndef SeismicHorizonsVerticalSense_h
#define SeismicHorizonsVerticalSense_h

#include "SurveyDescription.h"

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Accepts "Elevation (m)", but not "Depth below elevation 0".
bool IsElevation(std::string_view name);

/// Without a stated direction z increases upwards if no z is above 0 and one is below. Returns the reason.
std::string FindSense(SurveyDescription& survey, const std::vector<double>& z);
}

#endif
