// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Units.h"

#include "Common/Text/TextWords.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string ShortUnit(std::string_view unit)
{
  struct Name
  {
    std::string_view Long, Short;
  };
  constexpr std::array<Name, 15> names = { { { "m", "m" }, { "meters", "m" }, { "metres", "m" }, { "meter", "m" },
    { "metre", "m" }, { "ft", "ft" }, { "feet", "ft" }, { "foot", "ft" }, { "ms", "ms" }, { "msec", "ms" },
    { "millisecond", "ms" }, { "milliseconds", "ms" }, { "s", "s" }, { "second", "s" }, { "seconds", "s" } } };
  const std::string lower = ToLower(Trim(unit));
  const auto found =
    std::find_if(names.begin(), names.end(), [&lower](const Name& name) { return name.Long == lower; });
  return std::string(found == names.end() ? Trim(unit) : found->Short);
}

//----------------------------------------------------------------------------------------------------------------------
std::string KnownUnit(std::string_view unit)
{
  const std::string lower = ToLower(unit);
  return lower == "none" || lower == "unitless" || lower == "unknown" ? std::string() : std::string(unit);
}

//----------------------------------------------------------------------------------------------------------------------
void SetVerticalUnit(SurveyDescription& survey, std::string_view unit)
{
  survey.VerticalUnit = ShortUnit(unit);
  if (survey.VerticalDomain.empty() && !survey.VerticalUnit.empty())
  {
    survey.VerticalDomain = survey.VerticalUnit == "ms" || survey.VerticalUnit == "s" ? "time" : "depth";
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string OverrideSurvey(SurveyDescription& survey, const char* verticalUnit, const char* verticalDomain,
  const char* horizontalUnit, const char* coordinateSystem)
{
  const auto isGiven = [](const char* text) { return text && *text; };
  std::string warning;
  if (isGiven(verticalUnit))
  {
    if (!survey.VerticalUnit.empty() && survey.VerticalUnit != ShortUnit(verticalUnit))
    {
      warning = "z in " + survey.VerticalUnit + " in the file, replaced by VerticalUnit " + verticalUnit +
        ": numbers are not converted";
    }
    survey.VerticalDomain.clear();
    SetVerticalUnit(survey, verticalUnit);
  }
  survey.VerticalDomain = isGiven(verticalDomain) ? verticalDomain : survey.VerticalDomain;
  survey.HorizontalUnit = isGiven(horizontalUnit) ? horizontalUnit : survey.HorizontalUnit;
  survey.CoordinateSystem = isGiven(coordinateSystem) ? coordinateSystem : survey.CoordinateSystem;
  return warning;
}
}
