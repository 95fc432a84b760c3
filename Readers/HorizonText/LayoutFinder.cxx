// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTextParser.h"

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "FieldGuess.h"
#include "PickBlock.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MostSampleLines = 100;

/// The lines are spread, so that they are not of a single inline.
TextLines SampleLines(const TextLines& lines, const TextLayout& layout)
{
  TextLines picks;
  for (auto line = std::size_t(layout.HeaderLines); line < lines.size() && !IsEndMark(lines[line]); ++line)
  {
    if (!IsSkipped(lines[line]) && (layout.WhereColumn < 0 || layout.IsChosen(lines[line])))
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

[[noreturn]] void RefuseCount(const TextLayout& layout, std::size_t fields)
{
  throw ErrorAt(layout.HeaderLines + 1,
    std::to_string(fields) + " fields, expected one for each of the columns " + ListNames(layout.Columns));
}

/// Returns false if a required number is text.
bool LeaveOutText(TextLayout& layout, const TextLines& sample)
{
  for (std::size_t column = 0; column < layout.Columns.size(); ++column)
  {
    FieldRole& role = layout.Columns[column].Role;
    const ColumnValues values = LookAt(sample, layout, column);
    if (role == FieldRole::HorizonName && RoleOfExactName(layout.Columns[column].Name) != role && !values.AreNames)
    {
      role = values.AreText ? FieldRole::Ignored : FieldRole::Attribute; // A field "Event" may contain heights.
    }
    if (role == FieldRole::HorizonName || role == FieldRole::Ignored || !values.AreText)
    {
      continue;
    }
    if (role != FieldRole::Attribute)
    {
      return false;
    }
    role = FieldRole::Ignored;
  }
  return true;
}

/// Names that do not fit and are not required are cleared.
void MatchColumns(TextLayout& layout, const TextLines& sample, bool areRequired)
{
  const std::size_t fields = CountFields(sample, layout.Separator);
  if (fields == layout.Columns.size() + 1 && !IsNumber(SplitFields(sample.front(), layout.Separator).front()))
  {
    // OpendTect does not list the field of names that precedes its picks.
    layout.Columns.insert(layout.Columns.begin(), { FieldRole::HorizonName, "Name" });
  }
  if (fields != layout.Columns.size() &&
    !HaveFields(sample, layout.Separator, layout.CountUsed(), layout.Columns.size()))
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
  const Fields fields = SplitFields(line, FieldSeparator::Colons);
  return fields.size() >= 7 && ToLower(fields[0]) == "inline" && !IsNumber(fields[2]);
}

/// Tests for "nx ny n" and columns within nx and ny, from `first`.
bool IsLatticeSize(const TextLines& sample, double first = 0.0)
{
  const Fields sizes = SplitFields(sample.front(), FieldSeparator::Blanks);
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
        const Fields fields = SplitFields(line, FieldSeparator::Blanks);
        double i = 0.0;
        double j = 0.0;
        return fields.size() == 3 && ReadNumber(fields[0], i) == NumberKind::Finite &&
          ReadNumber(fields[1], j) == NumberKind::Finite && i >= first && i < columns + first && j >= first &&
          j < rows + first && i == std::round(i) && j == std::round(j);
      });
}

/// Words above picks may be a title such as "North East Frigg".
bool MayBeNames(const TextLayout& layout)
{
  const int x = layout.Find(FieldRole::X);
  const std::string name = x >= 0 ? ToLower(layout.Columns[std::size_t(x)].Name) : "";
  const bool isTitle = name.size() <= 5 && name.find("st") != std::string::npos; // east, este, oost
  return layout.Find(FieldRole::Z) >= 0 || (layout.HasLineOfNames && !isTitle);
}

/// With columns from 1 the line of sizes would be read as a pick.
void RefuseCountLine(const TextLines& lines, const TextLayout& layout, const TextLines& sample)
{
  if (sample.size() > 1 && IsLatticeSize(sample, 1.0) && !IsLatticeSize(sample))
  {
    std::int64_t picks = -1; // The line of sizes is no pick.
    for (auto line = std::size_t(layout.HeaderLines); line < lines.size(); ++line)
    {
      picks += IsSkipped(lines[line]) ? 0 : 1;
    }
    if (picks == ReadPositiveInteger(SplitFields(sample.front(), FieldSeparator::Blanks)[2]))
    {
      throw ErrorAt(layout.HeaderLines + 1,
        Quote(sample.front()) + " seems to be the number of picks below, expected a pick: skip it with HeaderLines");
    }
  }
}

/// Returns false if the first line does not determine the layout.
bool FindFixedLayout(TextLayout& layout, const TextLines& sample)
{
  using Role = FieldRole;
  if (SplitFields(sample.front(), FieldSeparator::Blanks).front() == "PROFILE")
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
    layout.Picks = ReadPositiveInteger(SplitFields(sample.front(), FieldSeparator::Blanks)[2]);
    layout.Columns = { { Role::Crossline, "i" }, { Role::Inline, "j" }, { Role::Z, "Z" } };
    return true;
  }
  return false;
}

/// Columns whose names say no place are taken in order. Words between blanks may be a title.
std::string DoubtOfNames(const TextLayout& layout, const std::vector<TextColumn>& names)
{
  const auto isZ = [](const TextColumn& name) { return name.Role == FieldRole::Z; };
  const bool areNames = layout.Separator != FieldSeparator::Blanks || std::any_of(names.begin(), names.end(), isZ);
  const std::string warning = "columns " + ListNames(names) + " are read in order as " + ListNames(layout.Columns) +
    ", since no name identifies the coordinates: set Columns if this is wrong";
  return areNames && names.size() == layout.Columns.size() ? warning : "";
}

/// z has the unit and domain of its own name; the first field, of names of horizons, may have no name.
void DescribeZByNames(TextLayout& layout, const std::vector<TextColumn>& names)
{
  const auto z = std::size_t(layout.Find(FieldRole::Z));
  const std::size_t unnamed = layout.Columns.size() - names.size();
  const bool isNamed = unnamed <= std::min<std::size_t>(z, 1);
  const std::string name = isNamed ? names[z - unnamed].Name : layout.Columns[z].Name;
  const std::string unit = isNamed && layout.Units.size() == names.size() ? layout.Units[z - unnamed] : "";
  DescribeZ(layout.Survey, name, unit);
}

/// Lines of other kinds may differ in all fields.
TextLines ChooseSample(const TextLines& lines, TextLayout& layout, const TextOptions& options)
{
  TextLines sample = SampleLines(lines, layout);
  if (!options.Where.empty() && !sample.empty())
  {
    layout.Separator = FindSeparator(sample);
    layout.ChooseLines(options.Where, options.Columns.empty() ? layout.Columns : ParseColumnList(options.Columns));
    sample = SampleLines(lines, layout);
  }
  if (sample.empty())
  {
    throw InputError("no picks after " + std::to_string(layout.HeaderLines) + " lines" +
      (options.Where.empty() ? "" : " with " + options.Where) + ", expected lines of numbers");
  }
  return sample;
}

/// Fields come from the user, the header, or their values, in this order.
void FindColumns(TextLayout& layout, const TextLines& sample, const TextOptions& options)
{
  if (layout.Kind == TextKind::Plain && !MayBeNames(layout))
  {
    layout.Columns.clear();
  }
  const bool hasNames =
    !layout.Columns.empty() && (layout.Kind != TextKind::Plain || (layout.HasLineOfNames && layout.HasPlaces()));
  if (!options.Columns.empty())
  {
    layout.Columns = ParseColumnList(options.Columns);
  }
  MatchColumns(layout, sample, hasNames || !options.Columns.empty());
  if (options.Columns.empty() && !LeaveOutText(layout, sample) && !hasNames)
  {
    layout.Columns.clear(); // The names do not match the picks.
  }
  if (layout.Columns.empty() || (layout.Kind == TextKind::Plain && options.Columns.empty() && !layout.HasPlaces()))
  {
    if (IsMatrix(sample, layout))
    {
      layout.Kind = TextKind::Matrix;
      layout.Columns.assign(CountFields(sample, layout.Separator), { FieldRole::Z, "Z" });
      return;
    }
    layout.Columns = GuessColumns(sample, layout);
    layout.IsGuessed = true;
  }
  if (layout.WhereColumn >= 0 && layout.Columns[std::size_t(layout.WhereColumn)].Role == FieldRole::Attribute)
  {
    layout.Columns[std::size_t(layout.WhereColumn)].Role = FieldRole::Ignored; // It is the same in all lines.
  }
  SettleRoles(layout.Columns);
  if (options.Columns.empty() && layout.Kind == TextKind::Plain)
  {
    NameByText(layout, sample);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout FindTextLayout(const TextLines& lines, const TextOptions& options)
{
  TextLayout layout = ReadTextHeader(lines, options.HeaderLines);
  layout.AreNullsUsual = options.NullValues == DefaultNulls;
  if (!layout.AreNullsUsual || (layout.Kind != TextKind::OpendTect && layout.Nulls.IsEmpty()))
  {
    layout.Nulls.Add(NullValues(options.NullValues)); // OpendTect writes 1e30, and some headers state another.
  }
  const TextLines sample = ChooseSample(lines, layout, options);
  if (HaveDecimalCommas(sample, layout.HeaderLines + 1))
  {
    std::vector<std::string> converted;
    std::transform(lines.begin(), lines.end(), std::back_inserter(converted), WithDecimalPoints);
    layout = FindTextLayout(TextLines(converted.begin(), converted.end()), options);
    layout.HasDecimalCommas = true;
    return layout;
  }
  layout.Separator = FindSeparator(sample);
  const std::size_t fields = SplitFields(sample.front(), layout.Separator).size();
  constexpr std::size_t mostFields = 1000;
  if (fields > mostFields && !IsMatrix(sample, layout))
  {
    throw ErrorAt(layout.HeaderLines + 1,
      std::to_string(fields) + " fields, expected at most " + std::to_string(mostFields) + ": is it a line of picks?");
  }
  if (layout.Kind == TextKind::Plain)
  {
    RefuseCountLine(lines, layout, sample);
  }
  const std::vector<TextColumn> names = layout.Columns;
  const bool isFixed = options.Columns.empty() && FindFixedLayout(layout, sample);
  if (!isFixed)
  {
    FindColumns(layout, sample, options);
  }
  if (layout.Kind == TextKind::Matrix)
  {
    return layout;
  }
  CheckRoles(layout.Columns);
  DescribeZByNames(layout, names);
  if (layout.IsGuessed)
  {
    RefuseDoubtfulColumns(sample, layout);
    layout.Doubt = DoubtOfColumns(sample, layout);
    layout.Doubt = layout.Doubt.empty() ? DoubtOfNames(layout, names) : layout.Doubt;
  }
  if (layout.Picks >= 0)
  {
    // The sample starts with the line of sizes.
    while (Trim(lines[std::size_t(layout.HeaderLines++)]).empty())
    {
    }
  }
  return layout;
}
}
