// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsUnits_h
#define SeismicHorizonsUnits_h

#include "SurveyDescription.h"

#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// A unit in short, "m", "ft", "ms" or "s"; any other as it is.
std::string ShortUnit(std::string_view unit);

/// Sets the vertical unit, and the domain that follows from it where none is said: "time" or "depth".
void SetVerticalUnit(SurveyDescription& survey, std::string_view unit);
}

#endif
