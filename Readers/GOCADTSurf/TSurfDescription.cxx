// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfBuilder.h"

#include "Common/Survey/Units.h"
#include "Common/Text/LineErrors.h"

#include <limits>

namespace SeismicHorizons
{
namespace
{

// No program writes more numbers per vertex; limits the memory of a short file.
constexpr int LargestSize = 1024;

std::vector<std::string> ReadWords(LineTokens& line)
{
  std::vector<std::string> words;
  while (!line.AtEnd())
  {
    words.emplace_back(line.NextQuoted());
  }
  return words;
}

/// Returns -1 for other characters.
int HexDigit(char c)
{
  const std::string_view digits = "0123456789abcdef";
  const std::size_t digit = digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
  return digit == std::string_view::npos ? -1 : static_cast<int>(digit);
}

/// Accepts "#rrggbb" and "red green blue alpha" with optional alpha.
std::optional<std::array<double, 3>> ReadColour(std::string_view text)
{
  std::array<double, 3> colour = {};
  const std::string line = std::string(text) + '\n';
  LineTokens words(line.data());
  const bool isHex = text.size() == 7 && text.front() == '#';
  for (std::size_t n = 0; n < colour.size(); ++n)
  {
    const int high = isHex ? HexDigit(text[2 * n + 1]) : 0;
    const int low = isHex ? HexDigit(text[2 * n + 2]) : 0;
    const bool isNumber = isHex || ReadAnyNumber(words.Next(), colour[n]) == NumberKind::Finite;
    colour[n] = isHex ? (16 * high + low) / 255.0 : colour[n];
    if (!isNumber || high < 0 || low < 0 || colour[n] < 0.0 || colour[n] > 1.0)
    {
      return {};
    }
  }
  return colour;
}

/// Empty unless the unit is a length or time.
std::string DomainOf(const std::string& text)
{
  const std::string unit = ToLower(text);
  if (unit == "s" || unit == "ms" || unit == "us")
  {
    return "time";
  }
  return unit == "m" || unit == "km" || unit == "ft" ? "depth" : "";
}

bool IsOfProperties(std::string_view keyword)
{
  return keyword == "PROPERTIES" || keyword == "ESIZES" || keyword == "NO_DATA_VALUES";
}
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfHeader::Take(std::string_view line)
{
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos)
  {
    return;
  }
  const std::string key = ToLower(Trim(line.substr(0, colon)));
  const std::string_view value = Unquote(line.substr(colon + 1));
  if (key == "name")
  {
    this->Name = std::string(value);
  }
  else if (key == "*solid*color")
  {
    this->Colour = ReadColour(value);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeOfCoordinates(std::string_view keyword, LineTokens& line, std::int64_t number)
{
  if (keyword == "NAME")
  {
    this->Surface.Survey.CoordinateSystem = std::string(Unquote(line.Rest()));
  }
  else if (keyword == "AXIS_UNIT")
  {
    this->Surface.Survey.HorizontalUnit = KnownUnit(line.NextQuoted());
    line.NextQuoted(); // x and y have the same unit.
    this->Surface.Survey.VerticalUnit = KnownUnit(line.NextQuoted());
    this->Surface.Survey.VerticalDomain = DomainOf(this->Surface.Survey.VerticalUnit);
  }
  else if (keyword == "ZPOSITIVE")
  {
    const std::string way = ToLower(Unquote(line.Rest()));
    if (way != "elevation" && way != "depth")
    {
      throw ErrorAt(number, "ZPOSITIVE " + Quote(Unquote(line.Rest())) + ", expected Elevation or Depth");
    }
    this->Surface.HasPositive = true;
    this->Surface.Positive = way == "depth" ? VerticalPositive::Depth : VerticalPositive::Elevation;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeOfProperties(std::string_view keyword, LineTokens& line, std::int64_t number)
{
  this->Line = number;
  if (IsOfProperties(keyword) && !this->Surface.Vertices.empty())
  {
    throw ErrorAt(number, std::string(keyword) + " after vertices, expected before the first vertex");
  }
  if (keyword == "PROPERTIES")
  {
    this->TakeNames(line);
    return;
  }
  if (keyword != "UNITS" && !IsOfProperties(keyword))
  {
    return;
  }
  std::vector<std::string> words = ReadWords(line);
  if (keyword == "NO_DATA_VALUES" && words.size() == 1)
  {
    words.resize(this->Surface.Properties.size(), words.front()); // Some programs write a single word for all.
  }
  if (keyword == "UNITS" && words.size() != this->Surface.Properties.size())
  {
    return; // Units with blanks cannot be assigned to properties.
  }
  this->RequireOneEach(keyword, words.size());
  for (std::size_t n = 0; n < words.size(); ++n)
  {
    if (keyword == "UNITS")
    {
      this->Surface.Properties[n].Unit = words[n] == "none" ? "" : words[n];
    }
    else if (keyword == "ESIZES")
    {
      this->TakeSize(words[n], this->Surface.Properties[n]);
    }
    else if (words[n] != "**none**" && ReadAnyNumber(words[n], this->Nulls[n]) == NumberKind::NotANumber)
    {
      throw ErrorAt(this->Line, "NO_DATA_VALUES " + Quote(words[n]) + ", expected a number or **none**");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeNames(LineTokens& line)
{
  if (!this->Surface.Properties.empty())
  {
    throw ErrorAt(this->Line, "PROPERTIES repeated, expected one such line for all of them");
  }
  for (std::string& name : ReadWords(line))
  {
    this->Surface.Properties.emplace_back().Name = std::move(name);
  }
  this->Nulls.assign(this->Surface.Properties.size(), NoValue);
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::TakeSize(std::string_view text, TSurfProperty& property) const
{
  const int size = ReadPositiveInteger(text);
  if (size < 1 || size > LargestSize)
  {
    throw ErrorAt(
      this->Line, "ESIZES " + Quote(text) + ", expected an integer from 1 to " + std::to_string(LargestSize));
  }
  property.Size = static_cast<std::size_t>(size);
}

//----------------------------------------------------------------------------------------------------------------------
void TSurfBuilder::RequireOneEach(std::string_view keyword, std::size_t found) const
{
  if (found != this->Surface.Properties.size())
  {
    throw ErrorAt(this->Line,
      std::to_string(found) + ' ' + std::string(keyword) + ", expected one for each of the " +
        std::to_string(this->Surface.Properties.size()) + " PROPERTIES");
  }
}
}
