// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FieldGuess.h"

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "Common/Text/TextNumbers.h"
#include "PairFit.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr const char* Remedy = ": name the columns in Columns, such as Inline, Crossline, X, Y, Z";
constexpr std::size_t MostColumns = 12; // fields that are compared with each other

std::string Two(std::size_t column)
{
  return std::to_string(column + 1) + " and " + std::to_string(column + 2);
}

std::vector<double> NumbersOf(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  std::vector<double> numbers;
  for (const std::string_view line : sample)
  {
    const Fields fields = SplitFields(line, layout.Separator);
    double value = 0.0;
    const bool isNumber = column < fields.size() && ReadNumber(fields[column], value) == NumberKind::Finite &&
      !layout.Nulls.IsNullNumber(value);
    numbers.push_back(isNumber ? value : std::numeric_limits<double>::quiet_NaN());
  }
  return numbers;
}

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

bool AreLikeCoordinates(const std::vector<double>& numbers)
{
  constexpr double least = 1e5;
  const auto ends = std::minmax_element(numbers.begin(), numbers.end());
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::abs(number) >= least; }) &&
    (*ends.first > 0.0 || *ends.second < 0.0) && *ends.second - *ends.first < 0.5 * std::abs(*ends.second) &&
    !IsConstant(numbers);
}

/// Wide fields may touch: "2000.00-1522.00" or "431000.006348000.00".
bool AreTouching(std::string_view field)
{
  constexpr std::ptrdiff_t fewest = 9; // Dates have eight digits.
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
    for (const std::string_view field : SplitFields(line, layout.Separator))
    {
      if (AreTouching(field))
      {
        throw InputError(Quote(field) + ", expected blanks between numbers: insert some where numbers touch");
      }
    }
  }
}

/// In "1522,06" the fields after commas have leading zeros.
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
        const Fields fields = SplitFields(line, layout.Separator);
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

void RefuseOtherPlaces(const TextLines& sample, const TextLayout& layout)
{
  if (layout.Find(FieldRole::X) >= 0 && layout.Find(FieldRole::Inline) >= 0)
  {
    return;
  }
  const std::size_t count = std::min(MostColumns, layout.Columns.size());
  for (std::size_t lines = 0; lines + 1 < count; ++lines)
  {
    for (std::size_t places = 0; places + 1 < count; ++places)
    {
      const bool areApart = lines + 1 < places || places + 1 < lines;
      const bool arePlaces = layout.Columns[places].Role == FieldRole::X;
      if (areApart && !arePlaces && FollowLines(sample, layout, lines, places))
      {
        throw InputError("columns " + Two(lines) + " look like line numbers, and columns " + Two(places) +
          " like their coordinates, expected x and y next to the line numbers" + Remedy);
      }
    }
  }
  for (std::size_t column = 0; column + 1 < count && layout.Find(FieldRole::X) < 0; ++column)
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
  const int z = layout.Find(FieldRole::Z);
  const std::vector<double> heights = NumbersOf(sample, layout, std::size_t(z));
  for (std::size_t column = std::size_t(z) + 1; column < std::min(MostColumns, layout.Columns.size()); ++column)
  {
    const std::vector<double> other = NumbersOf(sample, layout, column);
    if (layout.Columns[column].Role == FieldRole::Attribute && IsCounter(heights) && !IsCounter(other))
    {
      throw InputError("column " + std::to_string(z + 1) +
        (IsConstant(heights) ? " is the same in all lines" : " numbers the lines") + ", expected Z" + Remedy);
    }
  }
  const bool hasMore = layout.Columns.size() >= 4;
  const int first = std::max(layout.Find(FieldRole::X), layout.Find(FieldRole::Inline));
  if (first == 0 && hasMore)
  {
    const std::vector<double> numbers = NumbersOf(sample, layout, 0);
    const std::vector<double> next = NumbersOf(sample, layout, 1);
    if (IsCounter(numbers) && !IsConstant(numbers) && !IsCounter(next))
    {
      throw InputError("column 1 numbers the lines, expected coordinates or line numbers" + std::string(Remedy));
    }
  }
}

/// Line numbers start far from 0 and seldom have steps of five. Other whole numbers may be places, and x and y would be
/// swapped.
void RefuseSmallPlaces(const TextLines& sample, const TextLayout& layout)
{
  constexpr std::size_t fewest = 4; // Different values that determine a step.
  constexpr std::int64_t longest = 4;
  const int lines = layout.Find(FieldRole::Inline);
  for (int column = lines; lines >= 0 && layout.Find(FieldRole::X) < 0 && column <= lines + 1; ++column)
  {
    std::set<std::int64_t> numbers;
    for (const double number : NumbersOf(sample, layout, std::size_t(column)))
    {
      if (number == std::round(number) && std::abs(number) <= LargestPlace)
      {
        numbers.insert(std::int64_t(number));
      }
    }
    std::int64_t step = 0;
    for (const std::int64_t number : numbers)
    {
      step = std::gcd(step, number - *numbers.begin());
    }
    const bool areSteps = numbers.size() >= fewest && step > longest;
    if (!numbers.empty() && (*numbers.begin() == 0 || areSteps))
    {
      throw InputError("column " + std::to_string(column + 1) + " with whole numbers " +
        (areSteps ? "in steps of " + std::to_string(step) : std::string("from 0")) + ", so that columns " +
        Two(std::size_t(lines)) +
        " may be line numbers or coordinates, expected one of these: set Columns to Inline, Crossline, Z or to X, Y, "
        "Z");
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsMatrix(const TextLines& sample, const TextLayout& layout)
{
  const std::size_t count = CountFields(sample, layout.Separator);
  if (count <= MostColumns)
  {
    return false;
  }
  constexpr double smooth = 0.25; // fraction of the range, from field to field
  constexpr double alike = 0.1; // fraction by which ranges of fields differ
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto columns = Eigen::Index(count);
  Eigen::ArrayXXd rows = Eigen::ArrayXXd::Constant(Eigen::Index(sample.size()), columns, std::nan(""));
  for (std::size_t row = 0; row < sample.size(); ++row)
  {
    const Fields fields = SplitFields(sample[row], layout.Separator);
    for (std::size_t column = 0; column < std::min(count, fields.size()); ++column)
    {
      double number = 0.0;
      const bool isNumber =
        ReadNumber(fields[column], number) == NumberKind::Finite && !layout.Nulls.IsNullNumber(number);
      rows(Eigen::Index(row), Eigen::Index(column)) = isNumber ? number : std::nan("");
    }
  }
  const Eigen::ArrayXd least = rows.isFinite().select(rows, infinity).colwise().minCoeff();
  const Eigen::ArrayXd largest = rows.isFinite().select(rows, -infinity).colwise().maxCoeff();
  const auto isKnown = least <= largest;
  const double range = largest.maxCoeff() - least.minCoeff();
  const bool areAlike = isKnown.select(least, -infinity).maxCoeff() <= isKnown.select(largest, infinity).minCoeff() &&
    isKnown.select(largest - least, infinity).minCoeff() >= alike * range;
  const Eigen::ArrayXXd steps = (rows.rightCols(columns - 1) - rows.leftCols(columns - 1)).abs();
  const Eigen::ArrayXd numbers = steps.isFinite().cast<double>().colwise().sum();
  const Eigen::ArrayXd sums = steps.isFinite().select(steps, 0.0).colwise().sum();
  return areAlike || (sums / numbers.max(1.0)).maxCoeff() <= smooth * range;
}

//----------------------------------------------------------------------------------------------------------------------
void RefuseDoubtfulColumns(const TextLines& sample, const TextLayout& layout)
{
  RefuseTouching(sample, layout);
  RefuseDecimalCommas(sample, layout);
  RefuseOtherPlaces(sample, layout);
  RefuseSmallPlaces(sample, layout);
  if (layout.Find(FieldRole::Z) >= 0)
  {
    RefuseCounters(sample, layout);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string DoubtOfColumns(const TextLines& sample, const TextLayout& layout)
{
  const int x = layout.Find(FieldRole::X);
  const int y = layout.Find(FieldRole::Y);
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
    ? "x is above 1,000,000 and y below, as if y came first, and the columns have no names: set Columns if so"
    : "";
}
}
