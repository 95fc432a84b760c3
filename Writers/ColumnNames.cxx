// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnNames.h"

#include "Readers/HorizonText/TextLayout.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string Quoted(std::string text)
{
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace_if(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return '"' + text + '"';
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> PlaceNames(const SurveyDescription& survey)
{
  const auto name = [](const std::string& text, const std::string& unit)
  { return UnitOfName(text + " (" + unit + ")").empty() ? text : text + " (" + unit + ")"; };
  return { name("X", survey.HorizontalUnit), name("Y", survey.HorizontalUnit),
    name(survey.IsUpright ? "Elevation" : "Z", survey.VerticalUnit) };
}
}
