// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTextParser.h"

#include "Common/Survey/PickPlacement.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/TextFields.h"
#include "FieldGuess.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// Other programs do not use these extensions for tables of numbers.
bool IsOfPicks(const std::string& extension)
{
  constexpr std::array<std::string_view, 8> extensions = { "", "dat", "xyz", "asc", "ijz", "ijk", "rmsattr", "map" };
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

/// Lines may end with carriage returns alone, and the text may be in UTF-16.
std::vector<std::string> ListPickLines(std::istream& stream)
{
  std::string text = PeekText(stream, BytesToRecognise);
  text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
  std::vector<std::string> lines(1);
  for (const char c : text)
  {
    if (c == '\n' || c == '\r')
    {
      lines.emplace_back();
    }
    else
    {
      lines.back() += c;
    }
  }
  lines.pop_back(); // The last line may be incomplete.
  lines.erase(std::remove_if(lines.begin(), lines.end(),
                [](const std::string& line) { return IsSkipped(line) || line[0] == '%' || line[0] == '*'; }),
    lines.end());
  return lines;
}

struct FieldCount
{
  std::size_t Fields = 0;
  std::size_t Numbers = 0;
};

FieldCount CountNumbers(const std::string& line)
{
  const bool hasTabs = line.find('\t') != std::string::npos;
  const FieldSeparator separator = line.find(';') != std::string::npos            ? FieldSeparator::Semicolon
    : hasTabs                                                                     ? FieldSeparator::Tab
    : line.find(", ") != std::string::npos || line.find(' ') == std::string::npos ? FieldSeparator::Comma
                                                                                  : FieldSeparator::Blanks;
  FieldCount count;
  for (const std::string_view field : SplitFields(line, separator))
  {
    std::string number(field);
    std::replace(number.begin(), number.end(), ',', '.');
    double value = 0.0;
    ++count.Fields;
    count.Numbers += ReadNumber(number, value) == NumberKind::Finite ? 1 : 0;
  }
  return count;
}

bool IsEndOfLine(const std::string& line)
{
  const Fields fields = SplitFields(line, FieldSeparator::Blanks);
  return fields.size() == 3 && fields[0] == fields[1] && fields[1] == fields[2] &&
    ReadPositiveInteger(fields[0].substr(0, 3)) == 999;
}

/// Fields must be as many in all lines, at least three of them numbers, below a few titles.
bool AreColumns(const std::vector<std::string>& lines)
{
  constexpr std::size_t mostTitles = 5;
  constexpr std::size_t fewestLines = 4;
  constexpr std::size_t mostLines = 200;
  std::size_t first = 0;
  while (first < lines.size() && first <= mostTitles && CountNumbers(lines[first]).Numbers == 0)
  {
    ++first;
  }
  if (first > mostTitles || first + fewestLines > lines.size())
  {
    return false;
  }
  const std::size_t fields = CountNumbers(lines[first]).Fields;
  const std::size_t last = std::min(lines.size(), first + mostLines);
  return std::count_if(lines.begin() + std::ptrdiff_t(first), lines.begin() + std::ptrdiff_t(last),
           [fields](const std::string& line)
           {
             const FieldCount count = CountNumbers(line);
             return count.Fields == fields && count.Numbers >= 3;
           }) >= std::ptrdiff_t((last - first) * 9 / 10);
}

/// Tables of other programs have numbers below words, too.
bool IsOfOthers(const std::vector<std::string>& lines)
{
  constexpr std::array<std::string_view, 6> beginnings = { "variables", "title", "zone", "ply", "off", "solid" };
  const std::string first = lines.empty() ? "" : ToLower(Trim(lines.front()));
  return std::any_of(lines.begin(), lines.end() - 1, IsEndOfLine) ||
    std::any_of(beginnings.begin(), beginnings.end(),
      [&first](std::string_view beginning)
      {
        return StartsWith(first, beginning) &&
          (first.size() == beginning.size() || std::string_view(" \t=").find(first[beginning.size()]) < 3);
      });
}

/// Picks of a cube form a lattice, with few duplicates.
bool FormHorizons(PickTable picks)
{
  const SurveyHorizons found = PlacePicks(std::move(picks), PlacementOptions());
  std::int64_t points = 0;
  std::int64_t duplicates = 0;
  for (const LatticeHorizon& horizon : found.Horizons)
  {
    points += std::int64_t(horizon.Column.size());
    duplicates += horizon.DroppedDuplicates;
  }
  constexpr std::int64_t fewest = 4;
  constexpr double leastCover = 0.1; // Fraction of the columns within the bounds.
  const auto [i, j] = found.Lattice.Columns;
  return points >= fewest && 10 * duplicates <= points && std::min(i, j) >= 2 &&
    double(points) >= leastCover * double(i) * double(j);
}

/// Decides for extensions that other files share.
bool AreCertain(PickTable picks, const TextLayout& layout, const std::vector<std::string>& lines)
{
  if (layout.Kind != TextKind::Plain && layout.Kind != TextKind::LatticeIndices)
  {
    return true;
  }
  const int z = layout.Find(FieldRole::Z);
  const bool hasNames = !layout.IsGuessed && layout.Kind == TextKind::Plain;
  const FieldRole named = hasNames && z >= 0 ? ColumnOfName(layout.Columns[std::size_t(z)].Name).Role : FieldRole::Z;
  if (z < 0 || (named != FieldRole::Z && named != FieldRole::HorizonName)) // "SURFACE" may name heights.
  {
    return false; // z is the only field left, whatever its name.
  }
  return (hasNames || CountNumbers(lines.front()).Numbers >= 3) && FormHorizons(std::move(picks));
}
}

//----------------------------------------------------------------------------------------------------------------------
bool ArePicks(std::istream& stream, const std::string& extension)
{
  const std::vector<std::string> lines = ListPickLines(stream);
  if (lines.empty() || IsOfOthers(lines))
  {
    return false;
  }
  try
  {
    const TextLayout layout = ReadTextLayout(stream, {});
    if (layout.IsGuessed && layout.HasLineOfNames)
    {
      return false; // The names do not include a place.
    }
    PickTable picks = ReadFirstPicks(stream, layout);
    if (!IsOfPicks(extension))
    {
      return AreCertain(std::move(picks), layout, lines);
    }
    if (layout.IsGuessed && layout.Find(FieldRole::Inline) < 0)
    {
      PlacePicks(std::move(picks), PlacementOptions());
    }
    return true;
  }
  catch (const InputError&)
  {
    return IsOfPicks(extension) && AreColumns(lines);
  }
}
}
