// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsUnits_h
#define SeismicHorizonsUnits_h

#include "SurveyDescription.h"

#include <string>
#include <string_view>

namespace SeismicHorizons
{
std::string ShortUnit(std::string_view unit);

/// Sets an empty domain according to the unit.
void SetVerticalUnit(SurveyDescription& survey, std::string_view unit);
}

#endif
