// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnDoubts.h"

#include "ColumnGuess.h"
#include "Common/LineErrors.h"
#include "Common/TextFields.h"
#include "Common/TextNumbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr const char* Remedy = ": name the columns in Columns, such as Inline, Crossline, X, Y, Z";
constexpr std::size_t MostColumns = 12; // that are compared with each other

std::string Two(std::size_t column)
{
  return std::to_string(column + 1) + " and " + std::to_string(column + 2);
}

/// The numbers of a column in the lines of the sample; nan where there is none.
std::vector<double> NumbersOf(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  std::vector<double> numbers;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    double value = 0.0;
    const bool isNumber = column < fields.size() && ReadNumber(fields[column], value) == NumberKind::Finite &&
      !layout.Nulls.IsNullNumber(value);
    numbers.push_back(isNumber ? value : std::numeric_limits<double>::quiet_NaN());
  }
  return numbers;
}

/// Whether numbers are the same, or go on by the same step from line to line, in the first of which they do.
bool IsCounter(const std::vector<double>& numbers)
{
  constexpr std::size_t fewest = 5;
  for (std::size_t n = 2; n < numbers.size(); ++n)
  {
    if (!(numbers[n] - numbers[n - 1] == numbers[1] - numbers[0]))
    {
      return false;
    }
  }
  return numbers.size() >= fewest;
}

bool IsConstant(const std::vector<double>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [&](double number) { return number == numbers.front(); });
}

/// Large, of one sign, and near to each other beside their size, as coordinates in metres are.
bool AreLikeCoordinates(const std::vector<double>& numbers)
{
  constexpr double least = 1e5;
  const auto ends = std::minmax_element(numbers.begin(), numbers.end());
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::abs(number) >= least; }) &&
    (*ends.first > 0.0 || *ends.second < 0.0) && *ends.second - *ends.first < 0.5 * std::abs(*ends.second) &&
    !IsConstant(numbers);
}

/// "2000.00-1522.00" or "431000.006348000.00": numbers of columns as wide as these are, without a blank between.
bool AreTouching(std::string_view field)
{
  constexpr std::ptrdiff_t fewest = 9; // digits: dates have eight
  const bool isOfNumbers =
    std::all_of(field.begin(), field.end(), [](char c) { return IsDigit(c) || c == '.' || c == '-' || c == '+'; });
  const std::size_t sign = field.find_first_of("+-", 1);
  const std::ptrdiff_t points = std::count(field.begin(), field.end(), '.');
  return isOfNumbers && std::count_if(field.begin(), field.end(), IsDigit) >= fewest &&
    (points >= 2 || (points == 1 && sign != std::string_view::npos));
}

void RefuseTouching(const TextLines& sample, const TextLayout& layout)
{
  for (const std::string_view line : sample)
  {
    for (const std::string_view field : Split(line, layout.Separator))
    {
      if (AreTouching(field))
      {
        throw InputError(Quote(field) + ", expected blanks between numbers: insert some where numbers touch");
      }
    }
  }
}

/// "1522,06": behind a comma are always as many digits, with zeros in front.
void RefuseDecimalCommas(const TextLines& sample, const TextLayout& layout)
{
  if (layout.Separator != FieldSeparator::Comma)
  {
    return;
  }
  for (std::size_t column = 1; column < std::min(MostColumns, layout.Columns.size()); ++column)
  {
    std::size_t digits = 0;
    bool hasZero = false;
    const bool areDecimals = std::all_of(sample.begin(), sample.end(),
      [&](std::string_view line)
      {
        const Fields fields = Split(line, layout.Separator);
        const std::string_view field = column < fields.size() ? fields[column] : std::string_view();
        digits = digits == 0 ? field.size() : digits;
        hasZero = hasZero || (field.size() > 1 && field.front() == '0');
        return !field.empty() && field.size() == digits && std::all_of(field.begin(), field.end(), IsDigit);
      });
    if (areDecimals && hasZero)
    {
      throw InputError("fields such as \"00\" in column " + std::to_string(column + 1) +
        ", as after decimal commas, expected decimal points: replace these commas" + Remedy);
    }
  }
}

/// Line numbers and their places that stand in other columns than those that were taken for them.
void RefuseOtherPlaces(const TextLines& sample, const TextLayout& layout)
{
  if (layout.Find(ColumnRole::X) >= 0 && layout.Find(ColumnRole::Inline) >= 0)
  {
    return; // these follow each other
  }
  const std::size_t count = std::min(MostColumns, layout.Columns.size());
  for (std::size_t lines = 0; lines + 1 < count; ++lines)
  {
    for (std::size_t places = 0; places + 1 < count; ++places)
    {
      const bool areApart = lines + 1 < places || places + 1 < lines;
      const bool arePlaces = layout.Columns[places].Role == ColumnRole::X;
      if (areApart && !arePlaces && FollowLines(sample, layout, lines, places))
      {
        throw InputError("columns " + Two(lines) + " look like line numbers, and columns " + Two(places) +
          " like their places, expected x and y next to the line numbers" + Remedy);
      }
    }
  }
  for (std::size_t column = 0; column + 1 < count && layout.Find(ColumnRole::X) < 0; ++column)
  {
    if (AreLikeCoordinates(NumbersOf(sample, layout, column)) &&
      AreLikeCoordinates(NumbersOf(sample, layout, column + 1)))
    {
      throw InputError("columns " + Two(column) + " look like x and y, expected x and y in known columns" + Remedy);
    }
  }
}

void RefuseCounters(const TextLines& sample, const TextLayout& layout)
{
  const int z = layout.Find(ColumnRole::Z);
  const std::vector<double> heights = NumbersOf(sample, layout, std::size_t(z));
  for (std::size_t column = std::size_t(z) + 1; column < std::min(MostColumns, layout.Columns.size()); ++column)
  {
    const std::vector<double> other = NumbersOf(sample, layout, column);
    if (layout.Columns[column].Role == ColumnRole::Attribute && IsCounter(heights) && !IsCounter(other))
    {
      throw InputError("column " + std::to_string(z + 1) +
        (IsConstant(heights) ? " is the same in all lines" : " counts lines") + ", expected Z" + Remedy);
    }
  }
  const bool hasMore = layout.Columns.size() >= 4;
  const int first = std::max(layout.Find(ColumnRole::X), layout.Find(ColumnRole::Inline));
  if (first == 0 && hasMore)
  {
    const std::vector<double> numbers = NumbersOf(sample, layout, 0);
    const std::vector<double> next = NumbersOf(sample, layout, 1);
    if (IsCounter(numbers) && !IsConstant(numbers) && !IsCounter(next))
    {
      throw InputError("column 1 counts lines, expected coordinates or line numbers" + std::string(Remedy));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void RefuseDoubtfulColumns(const TextLines& sample, const TextLayout& layout)
{
  RefuseTouching(sample, layout);
  RefuseDecimalCommas(sample, layout);
  RefuseOtherPlaces(sample, layout);
  if (layout.Find(ColumnRole::Z) >= 0)
  {
    RefuseCounters(sample, layout);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string DoubtOfColumns(const TextLines& sample, const TextLayout& layout)
{
  const int x = layout.Find(ColumnRole::X);
  const int y = layout.Find(ColumnRole::Y);
  if (x < 0 || y < 0)
  {
    return {};
  }
  const auto isWithin = [&](int column, double least, double greatest)
  {
    const std::vector<double> numbers = NumbersOf(sample, layout, std::size_t(column));
    return std::all_of(
      numbers.begin(), numbers.end(), [&](double number) { return number >= least && number < greatest; });
  };
  return isWithin(x, 1e6, 1e7) && isWithin(y, 1e5, 1e6)
    ? "x in millions and y below one, as if y came first, in columns without names: set Columns if so"
    : "";
}
}
