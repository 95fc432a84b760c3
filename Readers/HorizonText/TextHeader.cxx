// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextHeader.h"

#include "Common/Survey/Units.h"
#include "Common/Text/TextFields.h"
#include "FieldGuess.h"

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
    this->TakeDegrees();
    return this->Layout;
  }

private:
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
    return IsComment(line) ? this->TakeComment(line) : this->IsRemark() || this->TakeRmsAttribute(line);
  }

  /// Remarks of OpenWorks may continue for several lines.
  bool IsRemark() const
  {
    return this->Layout.Kind == TextKind::OpenWorks &&
      std::any_of(this->Lines.begin() + std::ptrdiff_t(this->Line), this->Lines.end(),
        [](std::string_view line) { return StartsWith(line, "#End_of_Horizon"); });
  }

  bool TakePetrelLine(std::string_view line)
  {
    this->InPetrelHeader = !StartsWith(line, "END HEADER");
    if (this->InPetrelHeader)
    {
      this->Layout.Kind = TextKind::PetrelPoints;
      this->Layout.Nulls = NullValues("-999");
      FieldCursor name(line.substr(line.find(',') + 1), FieldSeparator::Comma);
      std::string_view field;
      name.Next(field);
      this->AddColumn(field);
    }
    return true;
  }

  /// RMS writes "Float name" above points with x, y, z and attributes.
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
      this->Layout.Columns = { { FieldRole::X, "X" }, { FieldRole::Y, "Y" }, { FieldRole::Z, "Z" } };
    }
    const FieldRole role = type == "String" ? FieldRole::Ignored : FieldRole::Attribute;
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
      this->Names = text; // The last comment before the picks may have the names.
    }
    return true;
  }

  /// OpendTect writes "1: Inline".
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

  /// EarthVision writes keys such as "Field: 3 z meters".
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
    else if (key == "units" || key == "unit in x and y direction") // Petrel writes the second key.
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

  void TakeFieldName(std::string_view value)
  {
    const Fields words = SplitFields(value, FieldSeparator::Blanks);
    if (words.size() >= 2)
    {
      this->Layout.Kind = TextKind::EarthVision;
      this->AddColumn(words[1]);
      this->Layout.Units.emplace_back(words.size() > 2 ? words[2] : "");
    }
  }

  /// OpenWorks writes "#Horizon_name____-> top" and lines that begin with @.
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

  /// The text is "Project_Unit_is: meters , NAME , PROJECTED_COORDINATE_SYSTEM".
  void TakeProjectUnit(std::string_view text)
  {
    const std::size_t colon = text.find(':');
    if (StartsWith(text, "Project_Unit_is") && colon != std::string_view::npos)
    {
      const Fields unitAndName = SplitFields(text.substr(colon + 1), FieldSeparator::Comma);
      this->Layout.Survey.CoordinateSystem = unitAndName.size() > 1 ? std::string(unitAndName[1]) : "";
    }
  }

  void AddColumn(std::string_view name)
  {
    this->Layout.Columns.push_back(ColumnOfName(Trim(name)));
    std::string& unit = this->Layout.Survey.HorizontalUnit;
    if (this->Layout.Columns.back().Role == FieldRole::X && unit.empty())
    {
      unit = ShortUnit(UnitOfName(name));
    }
  }

  void TakeNames()
  {
    if (!this->Layout.Columns.empty())
    {
      return;
    }
    const std::string names = FindNameLine(this->Lines, this->Line, this->Layout).value_or(JoinWords(this->Names));
    for (const std::string_view field : SplitFields(names, SeparatorOfNames(names)))
    {
      this->AddColumn(field);
    }
  }

  /// Longitude and latitude are x and y if no others are named.
  void TakeDegrees()
  {
    for (TextColumn& column : this->Layout.Columns)
    {
      const bool mayBe = column.Role == FieldRole::Attribute && !this->Layout.HasPlaces();
      const std::string name = mayBe ? ToLower(column.Name).substr(0, 3) : "";
      column.Role = name == "lon" ? FieldRole::X : name == "lat" ? FieldRole::Y : column.Role;
    }
  }

  const TextLines& Lines;
  std::size_t Line = 0;
  bool InPetrelHeader = false;
  std::string_view Names;
  TextLayout Layout;
};
}

//----------------------------------------------------------------------------------------------------------------------
TextLines SplitLines(std::string_view text)
{
  TextLines lines;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout ReadTextHeader(const TextLines& lines, int skippedLines)
{
  const std::size_t skipped = std::min(lines.size(), std::size_t(skippedLines));
  const TextLines rest(lines.begin() + std::ptrdiff_t(skipped), lines.end());
  TextLayout layout = HeaderReader(rest).Read();
  layout.HeaderLines += skippedLines;
  return layout;
}
}
