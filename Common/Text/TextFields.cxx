// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextFields.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
bool IsEndMark(std::string_view line)
{
  const std::string_view word = Trim(line);
  return word == "EOB" || word == "EOD" || word == "EOF" || word == "\x1a";
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSkipped(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#' || line[first] == '!';
}

//----------------------------------------------------------------------------------------------------------------------
NumberKind ReadNumber(std::string_view field, double& value)
{
  constexpr std::size_t mostCharacters = 64; // Longest number with a Fortran exponent.
  const NumberKind kind = ReadAnyNumber(field, value);
  if (kind != NumberKind::NotANumber || field.size() > mostCharacters || field.find_first_of("Dd") == field.npos)
  {
    return kind;
  }
  std::string number(field);
  std::replace_if(
    number.begin(), number.end(), [](char c) { return c == 'D' || c == 'd'; }, 'e');
  return ReadAnyNumber(number, value);
}

//----------------------------------------------------------------------------------------------------------------------
bool IsNumber(std::string_view field)
{
  double value = 0.0;
  return !field.empty() && ReadNumber(field, value) != NumberKind::NotANumber;
}

//----------------------------------------------------------------------------------------------------------------------
std::string WithoutDoubledQuotes(std::string_view field)
{
  std::string text(field);
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1))
  {
    text.erase(at, 1);
  }
  return text;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string_view> SplitFields(std::string_view line, FieldSeparator separator)
{
  std::vector<std::string_view> fields;
  FieldCursor cursor(line, separator);
  for (std::string_view field; cursor.Next(field);)
  {
    fields.push_back(field);
  }
  return fields;
}
}
