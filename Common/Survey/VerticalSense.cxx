// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalSense.h"

#include "Common/Text/TextWords.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
bool IsElevation(std::string_view name)
{
  const std::string lower = ToLower(name);
  const auto has = [&lower](const char* word) { return lower.find(word) != std::string::npos; };
  return (has("elev") || has("altitud") || has("hoogte") || has("hoehe") || has("h\xC3\xB6he") || has("cota")) &&
    !has("depth") && !has("tvd") && !has("tw") && !has("time");
}

//----------------------------------------------------------------------------------------------------------------------
std::string FindSense(SurveyDescription& survey, const std::vector<double>& z)
{
  if (survey.IsUpright)
  {
    return "as its format or name says";
  }
  const bool hasNegative = std::any_of(z.begin(), z.end(), [](double value) { return value < 0.0; });
  const bool hasPositive = std::any_of(z.begin(), z.end(), [](double value) { return value > 0.0; });
  survey.IsUpright = hasNegative && !hasPositive;
  return survey.IsUpright ? "as all z are negative" : "as depth and time do";
}
}
