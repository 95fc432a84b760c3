// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldGuess.h"

#include "Common/Survey/Units.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "PairFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
namespace
{
// Coordinates of surveys are larger.
constexpr double LargestLineNumber = 99999.0;

bool HasFields(std::string_view line, FieldSeparator separator, std::size_t least, std::size_t most)
{
  std::size_t fields = 0;
  FieldCursor cursor(line, separator);
  for (std::string_view field; cursor.Next(field);)
  {
    ++fields;
  }
  return fields <= most && fields + (cursor.EndsInSeparator() ? 1 : 0) >= least;
}

/// Dates and times have marks between digits: "2019-11-21", "12:30:01".
bool IsDate(std::string_view field)
{
  const auto isMark = [](char c) { return c == '-' || c == '/' || c == ':' || c == '.'; };
  return field.size() >= 6 && std::count_if(field.begin(), field.end(), isMark) >= 2 &&
    std::all_of(field.begin(), field.end(), [&](char c) { return IsDigit(c) || isMark(c) || c == 'T'; });
}

double LargestOf(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  double largest = 0.0;
  for (const std::string_view line : sample)
  {
    const Fields fields = SplitFields(line, layout.Separator);
    double value = 0.0;
    if (column < fields.size() && ReadNumber(fields[column], value) == NumberKind::Finite &&
      !layout.Nulls.IsNullNumber(value))
    {
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// Line numbers whose places are partly wrong, bent or noisy fit neither reading.
[[noreturn]] void RefuseDoubt(std::size_t lines, std::size_t places)
{
  throw InputError("columns " + std::to_string(lines + 1) + " and " + std::to_string(lines + 2) +
    " look like line numbers, and columns " + std::to_string(places + 1) + " and " + std::to_string(places + 2) +
    " may be their coordinates but do not follow them, expected coordinates that do, or other numbers: name the "
    "columns in "
    "Columns, such as Inline, "
    "Crossline, X, Y, Z");
}

/// Tests a field and the next one.
bool AreLineFields(const TextLines& sample, const TextLayout& layout, std::size_t field)
{
  return LookAt(sample, layout, field).AreLines && LookAt(sample, layout, field + 1).AreLines;
}

/// If the lines are too few or too similar to decide, large numbers are coordinates.
bool AreLinesAndPlaces(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places)
{
  const PairFit fit = FitPairs(sample, layout, lines, places);
  if (fit.AreTelling)
  {
    const bool areLines = AreLineFields(sample, layout, lines);
    if (!fit.AreAffine && ((fit.AreMostlyAffine && fit.AreLarger) || (fit.AreCoordinates && areLines)))
    {
      RefuseDoubt(lines, places);
    }
    return fit.AreAffine && fit.AreLarger;
  }
  const bool areBoth = fit.AreCoordinates && AreLineFields(sample, layout, lines);
  if (!areBoth && FollowOneLine(sample, layout, lines, places))
  {
    RefuseDoubt(lines, places);
  }
  return areBoth;
}

void RefuseLargeZ(const TextLines& sample, const TextLayout& layout, const std::vector<TextColumn>& columns)
{
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const double largest = columns[column].Role == FieldRole::Z ? LargestOf(sample, layout, column) : 0.0;
    if (largest > LargestLineNumber && largest < LargestPlace)
    {
      std::ostringstream text;
      text.precision(12);
      text << "column " << column + 1 << " with numbers up to " << largest << ", expected Z of at most "
           << LargestLineNumber << ": name the columns in Columns, such as Inline, Crossline, X, Y, Z";
      throw InputError(text.str());
    }
  }
}
bool IsWithComma(std::string_view field)
{
  const std::size_t comma = field.find(',');
  const bool isBetweenDigits = comma != std::string_view::npos && comma > 0 && comma + 1 < field.size() &&
    IsDigit(field[comma - 1]) && IsDigit(field[comma + 1]);
  return isBetweenDigits && IsNumber(std::string(field).replace(comma, 1, "."));
}

/// The comma in "1,522" may separate thousands.
bool MayBeThousands(std::string_view field)
{
  const std::size_t comma = field.find(',');
  return !IsWithComma(field) || (comma <= 4 && field.size() - comma == 4);
}
}

//----------------------------------------------------------------------------------------------------------------------
FieldSeparator FindSeparator(const TextLines& sample)
{
  constexpr std::size_t fewest = 3;
  for (const bool areEqual : { true, false })
  {
    for (const FieldSeparator separator : { FieldSeparator::Comma, FieldSeparator::Semicolon, FieldSeparator::Tab })
    {
      const std::size_t fields = CountFields(sample, separator);
      if (fields >= fewest && HaveFields(sample, separator, areEqual ? fields : fewest, areEqual ? fields : SIZE_MAX))
      {
        return separator;
      }
    }
  }
  return FieldSeparator::Blanks;
}

//----------------------------------------------------------------------------------------------------------------------
bool HaveDecimalCommas(const TextLines& sample, std::int64_t firstLine, std::size_t fewestFields)
{
  for (const FieldSeparator separator : { FieldSeparator::Semicolon, FieldSeparator::Tab, FieldSeparator::Blanks })
  {
    bool mayBeThousands = true;
    if (std::all_of(sample.begin(), sample.end(),
          [&](std::string_view line)
          {
            const Fields fields = SplitFields(line, separator);
            mayBeThousands = mayBeThousands && std::all_of(fields.begin(), fields.end(), MayBeThousands);
            return line.find('.') == std::string_view::npos && fields.size() >= fewestFields &&
              std::any_of(fields.begin(), fields.end(), IsWithComma);
          }))
    {
      if (mayBeThousands)
      {
        throw ErrorAt(firstLine,
          "numbers such as 1,522 with decimal commas or thousands separators, expected decimal points: replace them");
      }
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
bool HaveFields(const TextLines& sample, FieldSeparator separator, std::size_t least, std::size_t most)
{
  return std::all_of(
    sample.begin(), sample.end(), [=](std::string_view line) { return HasFields(line, separator, least, most); });
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t CountFields(const TextLines& sample, FieldSeparator separator)
{
  std::size_t count = SplitFields(sample.front(), separator).size();
  const bool endsInSeparator = HasFields(sample.front(), separator, count + 1, count);
  for (const std::string_view line : sample)
  {
    const Fields fields = SplitFields(line, separator);
    const bool mayBeMore = endsInSeparator || (count >= 3 && !IsNumber(fields.back()));
    count = mayBeMore ? std::max(count, fields.size()) : count;
  }
  return count;
}

//----------------------------------------------------------------------------------------------------------------------
ColumnValues LookAt(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  ColumnValues values;
  bool hasNumbers = false;
  bool areWhole = true;
  bool areUnits = true;
  bool areDates = true;
  bool isEverywhere = true;
  std::size_t lines = 0;
  std::set<std::string_view> different;
  for (const std::string_view line : sample)
  {
    const Fields fields = SplitFields(line, layout.Separator);
    double value = 0.0;
    if (column >= fields.size())
    {
      isEverywhere = false;
      continue; // Parsing the line reports the error.
    }
    const bool isNumber = ReadNumber(fields[column], value) != NumberKind::NotANumber;
    hasNumbers = hasNumbers || isNumber;
    areWhole = areWhole && (!isNumber || value == std::round(value));
    const std::string unit = ShortUnit(fields[column]);
    areUnits = areUnits && (unit == "m" || unit == "ft" || unit == "ms" || unit == "s");
    areDates = areDates && IsDate(fields[column]);
    different.insert(fields[column]);
    values.AreText = values.AreText || !(isNumber || layout.Nulls.IsNullText(fields[column]));
    lines += isNumber && value == std::round(value) && value >= 0.0 && value <= LargestLineNumber ? 1 : 0;
  }
  values.AreLines = lines >= MostOf(sample.size());
  values.AreText = values.AreText && !hasNumbers;
  constexpr std::size_t few = 20;
  values.AreNames = isEverywhere && !areUnits && !areDates && areWhole && (!hasNumbers || different.size() <= few);
  values.AreAllDifferent = sample.size() > few && different.size() == sample.size();
  return values;
}

//----------------------------------------------------------------------------------------------------------------------
bool FollowLines(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places)
{
  const PairFit fit = FitPairs(sample, layout, lines, places);
  return fit.AreTelling && fit.AreAffine && fit.AreLarger && AreLineFields(sample, layout, lines);
}

//----------------------------------------------------------------------------------------------------------------------
void NameByText(TextLayout& layout, const TextLines& sample)
{
  for (std::size_t column = 0; column < layout.Columns.size() && layout.Find(FieldRole::HorizonName) < 0; ++column)
  {
    TextColumn& text = layout.Columns[column];
    const ColumnValues values = LookAt(sample, layout, column);
    if (text.Role == FieldRole::Ignored && values.AreText && values.AreNames && !values.AreAllDifferent &&
      !IsNeverZ(text.Name))
    {
      text.Role = FieldRole::HorizonName;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TextColumn> GuessColumns(const TextLines& sample, const TextLayout& layout)
{
  const std::size_t count = CountFields(sample, layout.Separator);
  std::vector<TextColumn> columns;
  std::size_t first = 0;
  if (count > 0 && LookAt(sample, layout, 0).AreText)
  {
    const bool areIds = LookAt(sample, layout, 0).AreAllDifferent;
    columns.push_back({ areIds ? FieldRole::Ignored : FieldRole::HorizonName, areIds ? "-" : "Name" });
    first = 1;
  }
  const auto areBoth = [&](std::size_t lines, std::size_t places)
  { return count >= first + 5 && AreLinesAndPlaces(sample, layout, first + lines, first + places); };
  using Role = FieldRole;
  std::vector<Role> roles = { Role::X, Role::Y, Role::Z };
  if (areBoth(0, 2))
  {
    roles = { Role::Inline, Role::Crossline, Role::X, Role::Y, Role::Z };
  }
  else if (areBoth(2, 0))
  {
    roles = { Role::X, Role::Y, Role::Inline, Role::Crossline, Role::Z };
  }
  else if (AreLineFields(sample, layout, first))
  {
    roles = { Role::Inline, Role::Crossline, Role::Z };
  }
  for (std::size_t column = 0; first + column < count; ++column)
  {
    const Role role = column < roles.size() ? roles[column] : Role::Attribute;
    const bool isText = LookAt(sample, layout, first + column).AreText;
    columns.push_back({ isText ? Role::Ignored : role,
      role == Role::Attribute ? "Attribute " + std::to_string(column - roles.size() + 1) : RoleWord(role) });
  }
  RefuseLargeZ(sample, layout, columns);
  return columns;
}
}
