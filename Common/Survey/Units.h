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

/// Words of GOCAD such as "none" are no units.
std::string KnownUnit(std::string_view unit);

/// Sets an empty domain according to the unit.
void SetVerticalUnit(SurveyDescription& survey, std::string_view unit);

/// Texts that are given, neither null nor empty, replace those of the survey. Without a domain it follows from the unit.
/// Returns a warning if the survey has z in another unit, else an empty text.
std::string OverrideSurvey(SurveyDescription& survey, const char* verticalUnit, const char* verticalDomain,
  const char* horizontalUnit, const char* coordinateSystem);
}

#endif
