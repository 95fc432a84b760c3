// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextHeader.h"

#include "ColumnGuess.h"
#include "ColumnNames.h"
#include "Common/Survey/Units.h"
#include "Common/TextFields.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
bool IsComment(std::string_view line)
{
  return !line.empty() && std::string_view("#!@%*").find(line[0]) != std::string_view::npos;
}

/// Takes the lines of a header one after the other.
class HeaderReader
{
public:
  explicit HeaderReader(const TextLines& lines)
    : Lines(lines)
  {
  }

  TextLayout Read()
  {
    while (this->Line < this->Lines.size() && this->TakeLine(Trim(this->Lines[this->Line])))
    {
      ++this->Line;
    }
    this->Layout.HeaderLines = std::int64_t(this->Line);
    this->TakeNames();
    return this->Layout;
  }

private:
  /// False at the first line that is no part of a header.
  bool TakeLine(std::string_view line)
  {
    if (line.empty())
    {
      return true;
    }
    if (this->InPetrelHeader)
    {
      return this->TakePetrelLine(line);
    }
    if (StartsWith(line, "VERSION") || StartsWith(line, "BEGIN HEADER"))
    {
      this->InPetrelHeader = StartsWith(line, "BEGIN HEADER");
      return true;
    }
    return IsComment(line) ? this->TakeComment(line) : this->TakeRmsAttribute(line);
  }

  bool TakePetrelLine(std::string_view line)
  {
    this->InPetrelHeader = !StartsWith(line, "END HEADER");
    if (this->InPetrelHeader)
    {
      this->Layout.Kind = TextKind::PetrelPoints;
      this->Layout.Nulls = NullValues("-999");
      FieldCursor name(line.substr(line.find(',') + 1), FieldSeparator::Comma); // of "FLOAT,name", or "name"
      std::string_view field;
      name.Next(field);
      this->AddColumn(field);
    }
    return true;
  }

  /// "Float name" over points of RMS, which have x, y and z before their attributes.
  bool TakeRmsAttribute(std::string_view line)
  {
    constexpr std::array<std::string_view, 4> types = { "Float", "Int", "String", "Discrete" };
    const std::string_view type = line.substr(0, line.find(' '));
    if (std::find(types.begin(), types.end(), type) == types.end() || type.size() == line.size())
    {
      return false;
    }
    if (this->Layout.Kind != TextKind::RmsAttributes)
    {
      this->Layout.Kind = TextKind::RmsAttributes;
      this->Layout.Columns = { { ColumnRole::X, "X" }, { ColumnRole::Y, "Y" }, { ColumnRole::Z, "Z" } };
    }
    const ColumnRole role = type == "String" ? ColumnRole::Ignored : ColumnRole::Attribute;
    this->Layout.Columns.push_back({ role, std::string(Trim(line.substr(type.size()))) });
    return true;
  }

  bool TakeComment(std::string_view line)
  {
    const std::string_view text = Trim(line.substr(1));
    if (this->TakeNumberedName(text) || this->TakeField(text) || this->TakeArrow(line, text) || text.empty())
    {
      return true;
    }
    if (text.front() == '"')
    {
      this->Layout.Kind = TextKind::OpendTect;
      this->Names = text;
    }
    else if (text.find_first_not_of("- ") != std::string_view::npos)
    {
      this->Names = text; // the last one before the picks may name the columns
    }
    return true;
  }

  /// "1: Inline", of OpendTect.
  bool TakeNumberedName(std::string_view text)
  {
    const std::size_t colon = text.find(':');
    const bool isNumbered = colon != std::string_view::npos && colon > 0 &&
      std::all_of(text.begin(), text.begin() + std::ptrdiff_t(colon), [](char c) { return IsDigit(c); });
    if (isNumbered)
    {
      this->Layout.Kind = TextKind::OpendTect;
      this->AddColumn(text.substr(colon + 1));
    }
    return isNumbered;
  }

  /// "Field: 3 z meters" and other keys of EarthVision.
  bool TakeField(std::string_view text)
  {
    const std::size_t colon = text.find(':');
    const std::string key = ToLower(text.substr(0, colon));
    if (colon == std::string_view::npos)
    {
      return false;
    }
    const std::string_view value = Trim(text.substr(colon + 1));
    if (key == "field")
    {
      this->TakeFieldName(value);
    }
    else if (key == "units" || key == "unit in x and y direction") // the latter of Petrel
    {
      this->Layout.Survey.HorizontalUnit = ShortUnit(value);
    }
    else if (key == "z_units" || key == "unit in depth")
    {
      SetVerticalUnit(this->Layout.Survey, value);
    }
    else if (key == "null_value")
    {
      this->Layout.Nulls = NullValues(std::string(value));
    }
    return key == "field" || key == "units" || key == "z_units" || key == "null_value" || key == "type" ||
      key == "end" || key == "projection" || key == "grid_size" || key == "grid_space" || key == "z_field";
  }

  /// "3 z meters": the number, the name and perhaps a unit.
  void TakeFieldName(std::string_view value)
  {
    const Fields words = Split(value, FieldSeparator::Blanks);
    if (words.size() >= 2)
    {
      this->Layout.Kind = TextKind::EarthVision;
      this->AddColumn(words[1]);
      if (words.size() > 2 && this->Layout.Columns.back().Role == ColumnRole::Z)
      {
        SetVerticalUnit(this->Layout.Survey, words[2]);
      }
    }
  }

  /// "#Horizon_name____-> top" of OpenWorks, and its lines that begin with @.
  bool TakeArrow(std::string_view line, std::string_view text)
  {
    const std::size_t arrow = text.find("->");
    if (line.front() == '@')
    {
      this->Layout.Kind = TextKind::OpenWorks;
      this->TakeProjectUnit(text);
      return true;
    }
    if (arrow == std::string_view::npos)
    {
      return StartsWith(text, "End_of_Horizon");
    }
    this->Layout.Kind = TextKind::OpenWorks;
    const std::string_view key = text.substr(0, text.find_first_of("_-", text.find_last_not_of("_-", arrow - 1)));
    const std::string_view value = Trim(text.substr(arrow + 2));
    if (key == "Horizon_name")
    {
      this->Layout.HorizonName = std::string(value);
    }
    else if (key == "Export_XY_Unit")
    {
      this->Layout.Survey.HorizontalUnit = ShortUnit(value);
    }
    else if (key == "Export_Z_Unit")
    {
      SetVerticalUnit(this->Layout.Survey, value);
    }
    else if (key == "Horizon_data_domain")
    {
      this->Layout.Survey.VerticalDomain = ToLower(value);
    }
    return true;
  }

  /// "Project_Unit_is: meters , NAME , PROJECTED_COORDINATE_SYSTEM".
  void TakeProjectUnit(std::string_view text)
  {
    const std::size_t colon = text.find(':');
    if (StartsWith(text, "Project_Unit_is") && colon != std::string_view::npos)
    {
      const Fields unitAndName = Split(text.substr(colon + 1), FieldSeparator::Comma);
      this->Layout.Survey.CoordinateSystem = unitAndName.size() > 1 ? std::string(unitAndName[1]) : "";
    }
  }

  void AddColumn(std::string_view name)
  {
    this->Layout.Columns.push_back(ColumnOfName(Trim(name)));
    const ColumnRole role = this->Layout.Columns.back().Role;
    const std::string_view unit = UnitOfName(name);
    SurveyDescription& survey = this->Layout.Survey;
    if (role == ColumnRole::Z && !unit.empty() && survey.VerticalUnit.empty())
    {
      SetVerticalUnit(survey, unit);
    }
    else if (role == ColumnRole::X && !unit.empty() && survey.HorizontalUnit.empty())
    {
      survey.HorizontalUnit = ShortUnit(unit);
    }
  }

  /// Names in a line above the picks, a comment or not.
  void TakeNames()
  {
    if (!this->Layout.Columns.empty())
    {
      return;
    }
    if (!this->FindNamesBelowTitle() && !this->SkipTitles() && this->Line < this->Lines.size() &&
      this->IsLineOfNames(Trim(this->Lines[this->Line])))
    {
      this->Names = Trim(this->Lines[this->Line]);
      this->Layout.HasLineOfNames = true;
      this->Layout.NamesLine = std::string(this->Names);
      this->Layout.HeaderLines = std::int64_t(this->NextPick());
    }
    for (const std::string_view field : Split(this->Names, SeparatorOfNames(this->Names)))
    {
      this->AddColumn(field);
    }
  }

  /// Names with lines of text above them, or between them and the picks: titles, units, dashes. They say where picks are,
  /// and are as many as the picks have fields; else the text is no header that is known.
  bool FindNamesBelowTitle()
  {
    const std::size_t pick = this->FirstPick();
    for (std::size_t line = this->Line; line < pick; ++line)
    {
      const std::string_view names = Trim(this->Lines[line]);
      const FieldSeparator separator = SeparatorOfNames(names);
      if (!HasNumber(names) && Split(names, separator).size() == Split(this->Lines[pick], separator).size() &&
        SayPlaces(names, separator))
      {
        this->Names = names;
        this->Layout.HasLineOfNames = true;
        this->Layout.NamesLine = std::string(names);
        this->Layout.HeaderLines = std::int64_t(pick);
        return true;
      }
    }
    return false;
  }

  /// Several lines of text above picks, in none of which is a number: titles, and no names of columns.
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

  /// The next line that may be a pick; the one that is the next where none of some lines is.
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

  static bool SayPlaces(std::string_view names, FieldSeparator separator)
  {
    TextLayout layout;
    for (const std::string_view field : Split(names, separator))
    {
      layout.Columns.push_back(ColumnOfName(Trim(field)));
    }
    return layout.HasPlaces();
  }

  /// Mostly numbers, and at least two.
  static bool IsPick(std::string_view line)
  {
    return HaveNumbers(
      line, [](std::size_t numbers, std::size_t words) { return numbers >= 2 && 2 * numbers >= words; });
  }

  static bool HasNumber(std::string_view line)
  {
    return HaveNumbers(line, [](std::size_t numbers, std::size_t) { return numbers > 0; });
  }

  /// What holds of the numbers of a line, and of all its words, however these are separated.
  template <typename Holds>
  static bool HaveNumbers(std::string_view line, Holds&& holds)
  {
    constexpr std::array<FieldSeparator, 3> separators = { FieldSeparator::Colons, FieldSeparator::Comma,
      FieldSeparator::Semicolon };
    return std::any_of(separators.begin(), separators.end(),
      [&](FieldSeparator separator)
      {
        const Fields words = Split(line, separator);
        const auto numbers =
          std::count_if(words.begin(), words.end(), [](std::string_view word) { return IsNumber(Trim(word)); });
        return holds(std::size_t(numbers), words.size());
      });
  }

  /// Names may have blanks in them where anything else separates them.
  static FieldSeparator SeparatorOfNames(std::string_view names)
  {
    const auto has = [names](char c) { return names.find(c) != std::string_view::npos; };
    return has('\t') ? FieldSeparator::Tab
      : has(',')     ? FieldSeparator::Comma
      : has(';')     ? FieldSeparator::Semicolon
                     : FieldSeparator::Blanks;
  }

  /// Whether a line has no number, and the next that is not empty has one.
  bool IsLineOfNames(std::string_view line) const
  {
    const std::size_t next = this->NextPick();
    return !HasNumber(line) && next < this->Lines.size() && HasNumber(this->Lines[next]);
  }

  /// The next line that has something in it.
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
  std::size_t Line = 0;
  bool InPetrelHeader = false;
  std::string_view Names;
  TextLayout Layout;
};
}

//----------------------------------------------------------------------------------------------------------------------
bool IsNumber(std::string_view field)
{
  double value = 0.0;
  return !field.empty() && ReadNumber(field, value) != NumberKind::NotANumber;
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout ReadTextHeader(const TextLines& lines)
{
  return HeaderReader(lines).Read();
}
}
