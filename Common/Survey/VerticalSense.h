// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Few files say whether z is a depth or an elevation. Names and numbers do: Petrel writes depth and time with a minus
// sign, others without one.

#ifndef SeismicHorizonsVerticalSense_h
#define SeismicHorizonsVerticalSense_h

#include "SurveyDescription.h"

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Whether z counts upwards by the name of its column: "Elevation (m)", but not "Depth below elevation 0".
bool IsElevation(std::string_view name);

/// Where nothing says so yet, z counts upwards if none is above 0 and one is below. Returns the reason, for people.
std::string FindSense(SurveyDescription& survey, const std::vector<double>& z);
}

#endif
