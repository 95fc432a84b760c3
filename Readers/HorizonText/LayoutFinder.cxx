// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayoutFinder.h"

#include "ColumnNames.h"
#include "Common/Lattice.h"
#include "Common/LineErrors.h"
#include "Common/Survey/PlaneFit.h"
#include "Common/TextFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MostSampleLines = 100;
// Whole numbers up to here may be line numbers; coordinates of surveys are larger.
constexpr double LargestLineNumber = 99999.0;
constexpr double LeastCoordinate = 1e4;
constexpr double LargestPlace = 1e9; // on Earth, in any unit of length; beyond are no places, but whatever z may be
// How far places may be off those that line numbers give, as a part of a step: they are rounded, but to less than that.
constexpr double LargestMisfit = 0.1;
// The same as a part of the extent of the sample, where that is more.
constexpr double LargestPartOff = 0.02;

using Fields = std::vector<std::string_view>;

Fields Split(std::string_view line, FieldSeparator separator)
{
  Fields fields;
  FieldCursor cursor(line, separator);
  std::string_view field;
  while (cursor.Next(field))
  {
    fields.push_back(field);
  }
  return fields;
}

/// Some lines of picks behind the header, up to the end mark of a file: the first one, and others that are spread over
/// all, so that they are not of one inline only.
TextLines SampleLines(const TextLines& lines, std::int64_t first)
{
  TextLines picks;
  for (auto line = std::size_t(first); line < lines.size() && !IsEndMark(lines[line]); ++line)
  {
    if (!IsSkipped(lines[line]))
    {
      picks.push_back(lines[line]);
    }
  }
  const std::size_t stride = picks.size() / MostSampleLines + 1;
  TextLines sample;
  for (std::size_t pick = 0; pick < picks.size(); pick += stride)
  {
    sample.push_back(picks[pick]);
  }
  return sample;
}

/// Whether a line has so many fields. The last one may be empty behind a separator at the end.
bool HasFields(std::string_view line, FieldSeparator separator, std::size_t count)
{
  std::size_t fields = 0;
  FieldCursor cursor(line, separator);
  for (std::string_view field; cursor.Next(field);)
  {
    ++fields;
  }
  return fields == count || (fields + 1 == count && cursor.EndsInSeparator());
}

bool HaveFields(const TextLines& sample, FieldSeparator separator, std::size_t count)
{
  return std::all_of(sample.begin(), sample.end(),
    [separator, count](std::string_view line) { return HasFields(line, separator, count); });
}

/// How many fields lines have: those of the first, and one more that is empty there where others have it.
std::size_t CountFields(const TextLines& sample, FieldSeparator separator)
{
  const std::size_t fields = Split(sample.front(), separator).size();
  const bool hasMore = HasFields(sample.front(), separator, fields + 1) &&
    std::any_of(sample.begin(), sample.end(),
      [separator, fields](std::string_view line) { return Split(line, separator).size() == fields + 1; });
  return hasMore ? fields + 1 : fields;
}

/// The first of tabs, commas and semicolons that cuts all lines into equally many fields, at least three; else blanks.
FieldSeparator FindSeparator(const TextLines& sample)
{
  for (const FieldSeparator separator : { FieldSeparator::Comma, FieldSeparator::Semicolon, FieldSeparator::Tab })
  {
    const std::size_t fields = CountFields(sample, separator);
    if (fields >= 3 && HaveFields(sample, separator, fields))
    {
      return separator;
    }
  }
  return FieldSeparator::Blanks;
}

/// What the values of a column are like.
struct ColumnValues
{
  bool AreText = false; // none of them is a number, and some are not null
  bool AreLines = true; // whole, and as small as line numbers are
};

ColumnValues LookAt(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  ColumnValues values;
  bool hasNumbers = false;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    double value = 0.0;
    if (column >= fields.size())
    {
      continue; // reading the line will say so
    }
    const bool isNumber = ReadNumber(fields[column], value) != NumberKind::NotANumber;
    hasNumbers = hasNumbers || isNumber;
    values.AreText = values.AreText || !(isNumber || layout.Nulls.IsNullText(fields[column]));
    values.AreLines =
      values.AreLines && isNumber && value == std::round(value) && value >= 0.0 && value <= LargestLineNumber;
  }
  values.AreText = values.AreText && !hasNumbers; // else reading the line of the text will say so
  return values;
}

/// The first column of text that is left out has the names of horizons, where no other one has.
void NameByText(std::vector<TextColumn>& columns, const TextLines& sample, const TextLayout& layout)
{
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    if (columns[column].Role == ColumnRole::HorizonName)
    {
      return;
    }
  }
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    if (columns[column].Role == ColumnRole::Ignored && LookAt(sample, layout, column).AreText)
    {
      columns[column] = { ColumnRole::HorizonName, "Name" };
      return;
    }
  }
}

/// The largest size of the numbers in a column.
double LargestOf(const TextLines& sample, const TextLayout& layout, std::size_t column)
{
  double largest = 0.0;
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    double value = 0.0;
    if (column < fields.size() && ReadNumber(fields[column], value) == NumberKind::Finite &&
      !layout.Nulls.IsNullNumber(value))
    {
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// How two columns belong to two others.
struct PairFit
{
  bool AreTelling = false; // enough lines, not all on one inline
  bool AreAffine = false; // an affine map leads from the first pair to the second
  bool AreLarger = false; // steps of the second pair are longer than those of the first
  bool AreCoordinates = true; // all numbers of the second pair are as large as coordinates mostly are
};

/// Places are rounded, or off the lines by some noise, but they lie far apart: what is off counts beside their extent.
/// Where lines are of three dimensions anything but a place has no such map.
PairFit FitPairs(const TextLines& sample, const TextLayout& layout, std::size_t from, std::size_t to)
{
  struct Pair
  {
    Eigen::Vector2d Index, Place;
  };
  std::vector<Pair> pairs;
  PlaneFit fit;
  PairFit result;
  Eigen::Vector2d extent = Eigen::Vector2d::Zero();
  for (const std::string_view line : sample)
  {
    const Fields fields = Split(line, layout.Separator);
    std::array<double, 4> values = {};
    for (const std::size_t n : { 0, 1, 2, 3 })
    {
      const std::size_t column = n < 2 ? from + n : to + n - 2;
      if (column >= fields.size() || ReadNumber(fields[column], values[n]) != NumberKind::Finite)
      {
        result.AreCoordinates = false;
        return result;
      }
    }
    pairs.push_back({ { values[0], values[1] }, { values[2], values[3] } });
    fit.Add(pairs.back().Index - pairs.front().Index, pairs.back().Place - pairs.front().Place);
    extent = extent.cwiseMax((pairs.back().Place - pairs.front().Place).cwiseAbs());
    result.AreCoordinates = result.AreCoordinates && pairs.back().Place.cwiseAbs().minCoeff() > LeastCoordinate;
  }
  const std::optional<PlaneMap> map = fit.Solve();
  constexpr std::size_t fewest = 4; // three make a map whatever they are
  result.AreTelling = map && pairs.size() >= fewest;
  // As with a plane z and a constant attribute, steps may be parallel.
  if (!result.AreTelling || AreParallel(map->Steps.col(0), map->Steps.col(1)))
  {
    return result;
  }
  const double step = map->Steps.colwise().norm().minCoeff();
  const double most = std::max(LargestMisfit * step, LargestPartOff * extent.minCoeff());
  result.AreLarger = std::abs(map->Steps.determinant()) >= 1.0;
  result.AreAffine = std::all_of(pairs.begin(), pairs.end(),
    [&](const Pair& pair)
    {
      const Eigen::Vector2d expected = map->Origin + map->Steps * (pair.Index - pairs.front().Index);
      return (pair.Place - pairs.front().Place - expected).norm() <= most;
    });
  return result;
}

/// Whether columns hold line numbers and the places that belong to them, in this order. Where the lines have too few
/// numbers to tell, coordinates are taken for what they mostly are: large.
bool AreLinesAndPlaces(const TextLines& sample, const TextLayout& layout, std::size_t lines, std::size_t places)
{
  const PairFit fit = FitPairs(sample, layout, lines, places);
  if (fit.AreTelling)
  {
    return fit.AreAffine && fit.AreLarger;
  }
  return fit.AreCoordinates && LookAt(sample, layout, lines).AreLines && LookAt(sample, layout, lines + 1).AreLines;
}

/// What neither reading explains is refused: coordinates would become z.
void RefuseLargeZ(const TextLines& sample, const TextLayout& layout, const std::vector<TextColumn>& columns)
{
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const double largest = columns[column].Role == ColumnRole::Z ? LargestOf(sample, layout, column) : 0.0;
    if (largest > LargestLineNumber && largest < LargestPlace)
    {
      std::ostringstream text;
      text.precision(12);
      text << "column " << column + 1 << " with numbers up to " << largest << ", expected Z of at most " << LargestLineNumber
           << ": name the columns in Columns, such as Inline, Crossline, X, Y, Z";
      throw InputError(text.str());
    }
  }
}

/// Columns without names, by their values: a name first where it is text; x y il xl, il xl x y, il xl or x y; z, and
/// attributes.
std::vector<TextColumn> GuessColumns(const TextLines& sample, const TextLayout& layout)
{
  const std::size_t count = CountFields(sample, layout.Separator);
  std::vector<TextColumn> columns;
  std::size_t first = 0;
  if (count > 0 && LookAt(sample, layout, 0).AreText)
  {
    columns.push_back({ ColumnRole::HorizonName, "Name" });
    first = 1;
  }
  const auto areLines = [&](std::size_t column)
  { return LookAt(sample, layout, first + column).AreLines && LookAt(sample, layout, first + column + 1).AreLines; };
  const auto areBoth = [&](std::size_t lines, std::size_t places)
  { return count >= first + 5 && AreLinesAndPlaces(sample, layout, first + lines, first + places); };
  using Role = ColumnRole;
  std::vector<Role> roles = { Role::X, Role::Y, Role::Z };
  if (areBoth(0, 2))
  {
    roles = { Role::Inline, Role::Crossline, Role::X, Role::Y, Role::Z };
  }
  else if (areBoth(2, 0))
  {
    roles = { Role::X, Role::Y, Role::Inline, Role::Crossline, Role::Z };
  }
  else if (areLines(0))
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
  NameByText(columns, sample, layout);
  RefuseLargeZ(sample, layout, columns);
  return columns;
}

/// Fields such as "604123,25", at least three in each line, and no decimal point.
bool HaveDecimalCommas(const TextLines& sample)
{
  const auto isDecimal = [](std::string_view field)
  {
    const std::size_t comma = field.find(',');
    return comma != std::string_view::npos && comma > 0 && field.find(',', comma + 1) == std::string_view::npos &&
      comma + 1 < field.size() && IsDigit(field[comma - 1]) &&
      std::all_of(field.begin() + std::ptrdiff_t(comma) + 1, field.end(), IsDigit) &&
      IsNumber(field.substr(0, comma));
  };
  for (const FieldSeparator separator : { FieldSeparator::Semicolon, FieldSeparator::Tab, FieldSeparator::Blanks })
  {
    constexpr std::ptrdiff_t fewest = 3;
    if (std::all_of(sample.begin(), sample.end(),
          [&](std::string_view line)
          {
            const Fields fields = Split(line, separator);
            return line.find('.') == std::string_view::npos &&
              std::count_if(fields.begin(), fields.end(), isDecimal) >= fewest;
          }))
    {
      return true;
    }
  }
  return false;
}

[[noreturn]] void RefuseCount(const TextLayout& layout, std::size_t fields)
{
  throw ErrorAt(layout.HeaderLines + 1,
    std::to_string(fields) + " fields, expected one for each of the columns " + ListNames(layout.Columns));
}

/// Leaves out attributes that are text. False where text is what a number has to be.
bool LeaveOutText(TextLayout& layout, const TextLines& sample)
{
  for (std::size_t column = 0; column < layout.Columns.size(); ++column)
  {
    ColumnRole& role = layout.Columns[column].Role;
    if (role == ColumnRole::HorizonName || role == ColumnRole::Ignored || !LookAt(sample, layout, column).AreText)
    {
      continue;
    }
    if (role != ColumnRole::Attribute)
    {
      return false;
    }
    role = ColumnRole::Ignored;
  }
  return true;
}

/// Brings the columns of the header or the user into line with the fields of the picks. Where they do not fit, and are
/// not required, there are none.
void MatchColumns(TextLayout& layout, const TextLines& sample, bool areRequired)
{
  const std::size_t fields = CountFields(sample, layout.Separator);
  if (fields == layout.Columns.size() + 1 && !IsNumber(Split(sample.front(), layout.Separator).front()))
  {
    // OpendTect does not list the names of horizons in front of their picks.
    layout.Columns.insert(layout.Columns.begin(), { ColumnRole::HorizonName, "Name" });
  }
  if (fields != layout.Columns.size() && !HaveFields(sample, layout.Separator, layout.Columns.size()))
  {
    if (areRequired)
    {
      RefuseCount(layout, fields);
    }
    layout.Columns.clear();
  }
}

/// Charisma has words between the numbers: "INLINE : 476 XLINE : 320 626540.48 6073670.99 1236.45".
bool IsCharisma(std::string_view line)
{
  const Fields fields = Split(line, FieldSeparator::Colons);
  return fields.size() == 7 && ToLower(fields[0]) == "inline" && !IsNumber(fields[2]);
}

/// "nx ny n" and, behind it, columns within nx and ny.
bool IsLatticeSize(const TextLines& sample)
{
  const Fields sizes = Split(sample.front(), FieldSeparator::Blanks);
  if (sizes.size() != 3)
  {
    return false;
  }
  const int columns = ReadPositiveInteger(sizes[0]);
  const int rows = ReadPositiveInteger(sizes[1]);
  const int picks = ReadPositiveInteger(sizes[2]);
  return picks > 0 && picks <= double(columns) * rows &&
    std::all_of(sample.begin() + 1, sample.end(),
      [&](std::string_view line)
      {
        const Fields fields = Split(line, FieldSeparator::Blanks);
        double i = 0.0;
        double j = 0.0;
        return fields.size() == 3 && ReadNumber(fields[0], i) == NumberKind::Finite &&
          ReadNumber(fields[1], j) == NumberKind::Finite && i >= 0.0 && i < columns && j >= 0.0 && j < rows &&
          i == std::round(i) && j == std::round(j);
      });
}

/// Whether columns say where picks are.
bool HavePlaces(const TextLayout& layout)
{
  return (layout.Find(ColumnRole::X) >= 0 && layout.Find(ColumnRole::Y) >= 0) ||
    (layout.Find(ColumnRole::Inline) >= 0 && layout.Find(ColumnRole::Crossline) >= 0);
}

/// Layouts of which the first line behind the header tells all. False where it does not.
bool FindFixedLayout(TextLayout& layout, const TextLines& sample)
{
  using Role = ColumnRole;
  if (Split(sample.front(), FieldSeparator::Blanks).front() == "PROFILE")
  {
    layout.Kind = TextKind::Iesx;
    layout.Columns = { { Role::X, "X" }, { Role::Y, "Y" }, { Role::Z, "Z" }, { Role::Crossline, "Crossline" },
      { Role::Inline, "Inline" }, { Role::Attribute, "Amplitude" } };
    return true;
  }
  if (IsCharisma(sample.front()))
  {
    layout.Kind = TextKind::Charisma;
    layout.Separator = FieldSeparator::Colons;
    layout.Columns = { { Role::Ignored, "-" }, { Role::Inline, "Inline" }, { Role::Ignored, "-" },
      { Role::Crossline, "Crossline" }, { Role::X, "X" }, { Role::Y, "Y" }, { Role::Z, "Z" } };
    return true;
  }
  if (layout.Kind == TextKind::OpenWorks && CountFields(sample, FieldSeparator::Blanks) == 5)
  {
    layout.Columns = { { Role::Inline, "Inline" }, { Role::Crossline, "Crossline" }, { Role::X, "X" }, { Role::Y, "Y" },
      { Role::Z, "Z" } };
    return true;
  }
  if (layout.Kind == TextKind::Plain && IsLatticeSize(sample))
  {
    layout.Kind = TextKind::LatticeIndices;
    layout.Picks = ReadPositiveInteger(Split(sample.front(), FieldSeparator::Blanks)[2]);
    layout.Columns = { { Role::Crossline, "i" }, { Role::Inline, "j" }, { Role::Z, "Z" } };
    return true;
  }
  return false;
}
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout FindTextLayout(const TextLines& lines, const TextOptions& options)
{
  TextLayout layout = ReadTextHeader(lines);
  layout.Nulls.Add(NullValues(options.NullValues));
  const TextLines sample = SampleLines(lines, layout.HeaderLines);
  if (sample.empty())
  {
    throw InputError("no picks after " + std::to_string(layout.HeaderLines) + " lines, expected lines of numbers");
  }
  if (HaveDecimalCommas(sample))
  {
    throw ErrorAt(layout.HeaderLines + 1, "numbers with decimal commas, expected decimal points: replace the commas");
  }
  const bool isFixed = options.Columns.empty() && FindFixedLayout(layout, sample);
  if (!isFixed)
  {
    layout.Separator = FindSeparator(sample);
    const bool hasNames =
      !layout.Columns.empty() && (layout.Kind != TextKind::Plain || (layout.HasLineOfNames && HavePlaces(layout)));
    if (!options.Columns.empty())
    {
      layout.Columns = ParseColumnList(options.Columns);
    }
    MatchColumns(layout, sample, hasNames || !options.Columns.empty());
    if (options.Columns.empty() && !LeaveOutText(layout, sample) && !hasNames)
    {
      layout.Columns.clear(); // they are not those of these picks
    }
    if (layout.Columns.empty() || (layout.Kind == TextKind::Plain && options.Columns.empty() && !HavePlaces(layout)))
    {
      layout.Columns = GuessColumns(sample, layout);
      layout.IsGuessed = true;
    }
    SettleRoles(layout.Columns);
  }
  CheckRoles(layout.Columns);
  if (layout.Picks >= 0)
  {
    // The size is the first of the sample.
    while (Trim(lines[std::size_t(layout.HeaderLines++)]).empty())
    {
    }
  }
  return layout;
}
}
