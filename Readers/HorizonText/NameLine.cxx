// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextHeader.h"

#include "Common/Text/TextFields.h"
#include "FieldGuess.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
class NameFinder
{
public:
  NameFinder(const TextLines& lines, std::size_t first, TextLayout& layout)
    : Lines(lines)
    , Line(first)
    , Layout(layout)
  {
  }

  std::optional<std::string> Find()
  {
    if (this->FindNamesBelowTitle())
    {
      return JoinWords(this->Names);
    }
    if (this->SkipTitles() || this->Line >= this->Lines.size() || !this->IsLineOfNames(Trim(this->Lines[this->Line])))
    {
      return std::nullopt;
    }
    this->Names = Trim(this->Lines[this->Line]);
    this->Layout.HasLineOfNames = true;
    this->KeepNames(this->Line, this->NextPick());
    return JoinWords(this->Names);
  }

private:
  /// The names include the place, and are as many words as a pick has fields.
  bool FindNamesBelowTitle()
  {
    const std::size_t pick = this->FirstPick();
    for (std::size_t line = this->Line; line < pick; ++line)
    {
      const std::string_view names = Trim(this->Lines[line]);
      const FieldSeparator separator = SeparatorOfNames(names);
      if (!HasNumber(names) &&
        SplitFields(names, separator).size() == SplitFields(this->Lines[pick], separator).size() &&
        HavePlaces(names, separator))
      {
        this->Names = names;
        this->Layout.HasLineOfNames = true;
        this->KeepNames(line, pick);
        return true;
      }
    }
    return false;
  }

  /// A line of units may follow the names.
  void KeepNames(std::size_t first, std::size_t pick)
  {
    const FieldSeparator separator = SeparatorOfNames(this->Names);
    const Fields names = SplitFields(this->Names, separator);
    for (std::size_t line = first; line < pick; ++line)
    {
      const std::string_view text = Trim(this->Lines[line]);
      if (!text.empty())
      {
        this->Layout.NamesLines.emplace_back(text);
      }
      const Fields units = SplitFields(text, separator);
      const auto isUnit = [](std::string_view unit) { return !UnitOfName("_" + std::string(Trim(unit))).empty(); };
      if (line > first && units.size() == names.size() && std::any_of(units.begin(), units.end(), isUnit))
      {
        this->Layout.Units.assign(units.begin(), units.end());
      }
    }
    this->Layout.HeaderLines = std::int64_t(pick);
  }

  bool SkipTitles()
  {
    const std::size_t pick = this->FirstPick();
    std::size_t titles = 0;
    for (std::size_t line = this->Line; line < pick; ++line)
    {
      if (HasNumber(this->Lines[line]))
      {
        return false;
      }
      titles += Trim(this->Lines[line]).empty() ? 0 : 1;
    }
    if (titles > 1)
    {
      this->Layout.HeaderLines = std::int64_t(pick);
    }
    return titles > 1;
  }

  std::size_t FirstPick() const
  {
    constexpr std::size_t mostLines = 50;
    std::size_t pick = this->Line;
    const std::size_t end = std::min(this->Lines.size(), this->Line + mostLines);
    while (pick < end && !IsPick(this->Lines[pick]))
    {
      ++pick;
    }
    return pick < end ? pick : this->Line;
  }

  static bool HavePlaces(std::string_view names, FieldSeparator separator)
  {
    TextLayout layout;
    for (const std::string_view field : SplitFields(names, separator))
    {
      layout.Columns.push_back(ColumnOfName(Trim(field)));
    }
    return layout.HasPlaces();
  }

  /// A pick has at least two numbers, and at least half of its words are numbers.
  static bool IsPick(std::string_view line)
  {
    return HaveNumbers(
      line, [](std::size_t numbers, std::size_t words) { return numbers >= 2 && 2 * numbers >= words; });
  }

  static bool HasNumber(std::string_view line)
  {
    return HaveNumbers(line, [](std::size_t numbers, std::size_t) { return numbers > 0; });
  }

  template <typename Holds>
  static bool HaveNumbers(std::string_view line, Holds&& holds)
  {
    constexpr std::array<FieldSeparator, 3> separators = { FieldSeparator::Colons, FieldSeparator::Comma,
      FieldSeparator::Semicolon };
    return std::any_of(separators.begin(), separators.end(),
      [&](FieldSeparator separator)
      {
        const Fields words = SplitFields(line, separator);
        const auto numbers =
          std::count_if(words.begin(), words.end(), [](std::string_view word) { return IsNumber(Trim(word)); });
        return holds(std::size_t(numbers), words.size());
      });
  }

  bool IsLineOfNames(std::string_view line) const
  {
    const std::size_t next = this->NextPick();
    return !HasNumber(line) && next < this->Lines.size() && HasNumber(this->Lines[next]);
  }

  std::size_t NextPick() const
  {
    std::size_t next = this->Line + 1;
    while (next < this->Lines.size() && IsSkipped(this->Lines[next]))
    {
      ++next;
    }
    return next;
  }

  const TextLines& Lines;
  const std::size_t Line;
  TextLayout& Layout;
  std::string_view Names;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<std::string> FindNameLine(const TextLines& lines, std::size_t first, TextLayout& layout)
{
  return NameFinder(lines, first, layout).Find();
}

//----------------------------------------------------------------------------------------------------------------------
FieldSeparator SeparatorOfNames(std::string_view names)
{
  const auto has = [names](char c) { return names.find(c) != std::string_view::npos; };
  return has('\t') ? FieldSeparator::Tab
    : has(',')     ? FieldSeparator::Comma
    : has(';')     ? FieldSeparator::Semicolon
                   : FieldSeparator::Blanks;
}

//----------------------------------------------------------------------------------------------------------------------
std::string JoinWords(std::string_view names)
{
  std::string joined(names);
  for (const std::string_view words : { "two way travel time", "two way time", "two-way travel time", "two-way time" })
  {
    const std::size_t found = ToLower(joined).find(words);
    if (found != std::string::npos)
    {
      joined.replace(found, words.size(), "TWT");
    }
  }
  return joined;
}
}
