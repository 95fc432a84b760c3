// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultColumns.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"
#include "FaultLineFormats.h"
#include "Readers/HorizonText/FieldGuess.h"
#include "Readers/HorizonText/PickBlock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 7> RoleNames = { "-", "X", "Y", "Z", "Fault", "Stick", "Node" };
constexpr std::size_t MostLinesOfSample = 2000;

std::string Letters(std::string_view name)
{
  std::string letters = ToLower(name.substr(0, name.find_first_of("([{", 1)));
  letters.erase(
    std::remove_if(letters.begin(), letters.end(), [](char c) { return c < 'a' || c > 'z'; }), letters.end());
  return letters;
}

FaultRole RoleOf(FieldRole role)
{
  switch (role)
  {
    case FieldRole::X:
      return FaultRole::X;
    case FieldRole::Y:
      return FaultRole::Y;
    case FieldRole::Z:
      return FaultRole::Z;
    case FieldRole::HorizonName:
      return FaultRole::Fault;
    default:
      return FaultRole::Ignored;
  }
}

FaultRole RoleOfFaultColumn(std::string_view name)
{
  const std::string letters = Letters(name);
  const auto has = [&letters](const char* word) { return letters.find(word) != std::string::npos; };
  if (has("node") || has("knot") || has("vertex"))
  {
    return FaultRole::Node;
  }
  if (has("stick") || has("segment") || letters == "seg" || letters == "segid" || has("polyline") || letters == "part")
  {
    return FaultRole::Stick;
  }
  const FaultRole role = RoleOf(RoleOfName(name));
  const bool isFault = has("fault") || letters == "flt" || has("feature");
  return role == FaultRole::Ignored && isFault ? FaultRole::Fault : role;
}

bool HavePlace(const std::vector<FaultRole>& roles)
{
  const auto has = [&roles](FaultRole role) { return std::find(roles.begin(), roles.end(), role) != roles.end(); };
  return has(FaultRole::X) && has(FaultRole::Y) && has(FaultRole::Z);
}

/// The first column of each role keeps it.
std::vector<FaultRole> KeepFirst(std::vector<FaultRole> roles)
{
  for (auto role = roles.begin(); role != roles.end(); ++role)
  {
    if (*role != FaultRole::Ignored && std::find(roles.begin(), role, *role) != role)
    {
      *role = FaultRole::Ignored;
    }
  }
  return roles;
}

// ---- Values ---------------------------------------------------------------------------------------------------------

/// The values of a column.
struct Seen
{
  bool AreText = false; // at least one is no number
  bool AreWhole = true;
  bool Count = true; // from 0 or 1 to the end of the file
  bool GrowInRuns = true; // by 1, from 0 or 1 on again and again
  bool AreRuns = false; // equal over lines
};

Seen LookAtValues(const std::vector<Fields>& rows, std::size_t column)
{
  Seen seen;
  double last = 0.0;
  std::size_t equal = 0;
  for (std::size_t n = 0; n < rows.size(); ++n)
  {
    double value = 0.0;
    const NumberKind kind = ReadNumber(rows[n][column], value);
    if (kind == NumberKind::NotANumber)
    {
      seen.AreText = true;
      return seen;
    }
    if (kind == NumberKind::NotFinite)
    {
      seen.AreWhole = seen.Count = seen.GrowInRuns = false; // as z of points to leave out
      continue;
    }
    const bool isStart = value == 0.0 || value == 1.0;
    seen.AreWhole = seen.AreWhole && value == std::round(value);
    seen.Count = seen.Count && (n == 0 ? isStart : value == last + 1.0);
    seen.GrowInRuns = seen.GrowInRuns && (n == 0 ? isStart : value == last + 1.0 || (isStart && last > 0.0));
    equal += n > 0 && value == last ? 1 : 0;
    last = value;
  }
  seen.AreRuns = seen.AreWhole && 2 * equal >= rows.size() - 1 && rows.size() > 1;
  return seen;
}

/// Text is the name of the fault. Numbers are an index of lines, x, y, z, and whole ones that tell lines apart, which
/// may also stand before x, or before z.
std::vector<FaultRole> GuessRoles(const std::vector<Fields>& rows)
{
  const std::size_t size = rows.front().size();
  std::vector<FaultRole> roles(size, FaultRole::Ignored);
  std::vector<Seen> seen;
  std::vector<std::size_t> numbers;
  for (std::size_t column = 0; column < size; ++column)
  {
    seen.push_back(LookAtValues(rows, column));
    if (seen.back().AreText)
    {
      roles[column] = FaultRole::Fault;
    }
    else
    {
      numbers.push_back(column);
    }
  }
  const auto tells = [&](std::size_t n) { return seen[numbers[n]].AreRuns || seen[numbers[n]].GrowInRuns; };
  std::size_t first = numbers.size() > 3 && seen[numbers[0]].Count && rows.size() > 2 ? 1 : 0;
  const bool tellsAtEnd = !numbers.empty() && tells(numbers.size() - 1);
  while (first + 3 < numbers.size() && !tellsAtEnd && tells(first))
  {
    roles[numbers[first]] = seen[numbers[first]].AreRuns ? FaultRole::Stick : FaultRole::Node;
    ++first;
  }
  if (first + 3 > numbers.size())
  {
    return {};
  }
  std::vector<std::size_t> rest(numbers.begin() + std::ptrdiff_t(first), numbers.end());
  roles[rest[0]] = FaultRole::X;
  roles[rest[1]] = FaultRole::Y;
  const bool isSegmentFirst = rest.size() > 3 && seen[rest[2]].AreRuns && !seen[rest[3]].AreRuns;
  roles[rest[isSegmentFirst ? 3 : 2]] = FaultRole::Z;
  for (std::size_t n = isSegmentFirst ? 2 : 3; n < rest.size(); ++n)
  {
    FaultRole& role = roles[rest[n]];
    if (role == FaultRole::Ignored && seen[rest[n]].AreWhole)
    {
      const bool hasStick = std::find(roles.begin(), roles.end(), FaultRole::Stick) != roles.end();
      role = hasStick || (seen[rest[n]].GrowInRuns && !seen[rest[n]].AreRuns) ? FaultRole::Node : FaultRole::Stick;
    }
  }
  return KeepFirst(roles);
}

// ---- Lines ----------------------------------------------------------------------------------------------------------

TextLines SampleOf(const TextLines& lines, std::int64_t first)
{
  TextLines sample;
  for (auto n = std::size_t(first); n < lines.size() && sample.size() < MostLinesOfSample; ++n)
  {
    if (!IsSkipped(lines[n]) && !SeparatesFaultLines(lines[n]))
    {
      sample.push_back(lines[n]);
    }
  }
  return sample;
}

std::vector<FaultRole> ParseRoles(const std::string& list)
{
  const bool hasCommas = list.find(',') != std::string::npos;
  std::vector<FaultRole> roles;
  for (const std::string_view name : SplitFields(list, hasCommas ? FieldSeparator::Comma : FieldSeparator::Blanks))
  {
    roles.push_back(RoleOfFaultColumn(Trim(name)));
  }
  if (!HavePlace(roles) || KeepFirst(roles) != roles)
  {
    throw InputError(
      "columns " + list + " of fault lines, expected X, Y and Z, and perhaps Fault, Stick and Node, each once");
  }
  return roles;
}

bool IsElevationAt(const TextLayout& header, int column)
{
  return column >= 0 && std::size_t(column) < header.Columns.size() &&
    IsElevation(header.Columns[std::size_t(column)].Name);
}

/// Names above the numbers, if these say where the points are. Throws InputError unless there are as many fields, but for
/// empty ones at the end: else names would be of other fields. "x y z" alone says no more than the values do.
std::optional<std::vector<FaultRole>> RolesOfNames(const TextLayout& header, const std::vector<Fields>& rows)
{
  std::vector<FaultRole> roles;
  for (const TextColumn& column : header.Columns)
  {
    const FaultRole role = RoleOfFaultColumn(column.Name);
    roles.push_back(role == FaultRole::Ignored ? RoleOf(column.Role) : role);
  }
  roles = KeepFirst(roles);
  if (!HavePlace(roles) && roles.size() != rows.front().size())
  {
    return std::nullopt;
  }
  if (!HavePlace(roles))
  {
    throw ErrorAt(header.HeaderLines, "column names without x, y and z, expected all three: set Columns");
  }
  const bool arePlaces = roles == std::vector<FaultRole>{ FaultRole::X, FaultRole::Y, FaultRole::Z };
  if (arePlaces && rows.front().size() > roles.size() && !IsElevationAt(header, 2))
  {
    return std::nullopt;
  }
  for (const Fields& row : rows)
  {
    // Of fewer fields in a later line the parser tells.
    const bool isLess = &row == &rows.front() && row.size() < roles.size();
    const auto isFilled = [](std::string_view field) { return !field.empty(); };
    if (isLess ||
      (row.size() > roles.size() && std::any_of(row.begin() + std::ptrdiff_t(roles.size()), row.end(), isFilled)))
    {
      throw ErrorAt(header.HeaderLines + 1 + (&row - rows.data()),
        std::to_string(row.size()) + " fields below " + std::to_string(roles.size()) +
          " column names, expected one field for each: set Columns");
    }
  }
  return roles;
}

}

//----------------------------------------------------------------------------------------------------------------------
int FaultColumns::Find(FaultRole role) const
{
  const auto found = std::find(this->Roles.begin(), this->Roles.end(), role);
  return found == this->Roles.end() ? -1 : int(found - this->Roles.begin());
}

//----------------------------------------------------------------------------------------------------------------------
std::string FaultColumns::Describe() const
{
  std::string text;
  for (const FaultRole role : this->Roles)
  {
    text += (text.empty() ? "" : ", ") + std::string(RoleNames[std::size_t(role)]);
  }
  return text + (this->EndInName ? ", Fault and Stick" : "");
}

//----------------------------------------------------------------------------------------------------------------------
bool IsEndOfPart(std::string_view line)
{
  FieldCursor cursor(line, FieldSeparator::Blanks);
  std::string_view field;
  int fields = 0;
  for (double value = 0.0; cursor.Next(field); ++fields)
  {
    if (ReadNumber(field, value) != NumberKind::Finite || value != EndOfPart)
    {
      return false;
    }
  }
  return fields == 3;
}

//----------------------------------------------------------------------------------------------------------------------
bool SeparatesFaultLines(std::string_view line)
{
  const std::string_view text = Trim(line);
  return text.empty() || text.front() == '>' || StartsWith(text, "->") || IsEndMark(text) || IsEndOfPart(text);
}

//----------------------------------------------------------------------------------------------------------------------
FaultColumns FindFaultColumns(const TextLines& lines, const FaultTextOptions& options)
{
  const TextLayout header = ReadTextHeader(lines, options.HeaderLines);
  FaultColumns columns;
  columns.Survey = header.Survey;
  columns.HeaderLines = header.HeaderLines;
  const TextLines sample = SampleOf(lines, columns.HeaderLines);
  if (sample.empty())
  {
    throw CutOffAt(std::max<std::int64_t>(1, std::int64_t(lines.size())), "end of file, expected fault lines");
  }
  if (HaveDecimalCommas(sample, columns.HeaderLines + 1))
  {
    std::vector<std::string> converted;
    std::transform(lines.begin(), lines.end(), std::back_inserter(converted), WithDecimalPoints);
    columns = FindFaultColumns(TextLines(converted.begin(), converted.end()), options);
    columns.HasDecimalCommas = true;
    return columns;
  }
  // The last line may be cut off.
  columns.Separator = FindSeparator(sample.size() > 2 ? TextLines(sample.begin(), sample.end() - 1) : sample);
  std::vector<Fields> rows;
  for (const std::string_view line : sample)
  {
    rows.push_back(SplitFields(line, columns.Separator));
  }
  const std::size_t fields = rows.front().size();
  const bool areEqual =
    std::all_of(rows.begin(), rows.end(), [fields](const Fields& row) { return row.size() == fields; });
  if (!options.Columns.empty())
  {
    columns.Roles = ParseRoles(options.Columns);
  }
  else if (const auto named = RolesOfNames(header, rows))
  {
    columns.Roles = *named;
    const int z = columns.Find(FaultRole::Z);
    columns.IsUpright = IsElevationAt(header, z);
    DescribeZ(columns.Survey, header.Columns[std::size_t(z)].Name);
    columns.SaysFaults = std::any_of(header.Columns.begin(), header.Columns.end(),
      [](const TextColumn& column)
      {
        const std::string letters = Letters(column.Name);
        return letters.find("fault") != std::string::npos || letters.find("stick") != std::string::npos;
      });
  }
  else if (areEqual && fields >= 3)
  {
    columns.Roles = GuessRoles(rows);
  }
  if (columns.Roles.empty())
  {
    columns.Roles = { FaultRole::X, FaultRole::Y, FaultRole::Z };
    columns.EndInName = true;
  }
  return columns;
}
}
