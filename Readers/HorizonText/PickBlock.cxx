// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickBlock.h"

#include "Common/Horizon/Types.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace SeismicHorizons
{
namespace
{
/// Nearly all numbers are plain.
bool IsFinite(std::string_view field, double& value)
{
  return ReadPlainNumber(field.data(), value) == field.data() + field.size() ||
    ReadNumber(field, value) == NumberKind::Finite;
}

bool IsControl(char c)
{
  return static_cast<unsigned char>(c) < ' ';
}

/// Functions are defined inside the class so that compilers inline them.
class BlockParser
{
public:
  explicit BlockParser(const TextLayout& layout)
    : Layout(layout)
    , X(layout.Find(FieldRole::X))
    , Y(layout.Find(FieldRole::Y))
    , Z(layout.Find(FieldRole::Z))
    , Used(layout.CountUsed())
  {
    this->Block.Values.resize(layout.Columns.size());
  }

  PickBlock Parse(std::string_view lines)
  {
    const char* line = lines.data();
    const char* const last = line + lines.size();
    while (line != last && this->Block.ErrorLine < 0)
    {
      const auto* const end = static_cast<const char*>(std::memchr(line, '\n', std::size_t(last - line)));
      this->ParseLine(std::string_view(line, std::size_t(end - line)));
      line = end + 1;
      ++this->Block.Lines;
    }
    return std::move(this->Block);
  }

private:
  void ParseLine(std::string_view line)
  {
    const std::vector<std::string>& names = this->Layout.NamesLines;
    if (IsSkipped(line) || (!names.empty() && std::find(names.begin(), names.end(), Trim(line)) != names.end()))
    {
      const bool hasWord = std::any_of(line.begin(), line.end(), [](char c) { return std::isalpha(c & 0x7F) != 0; });
      this->Comment = this->Comment < 0 && hasWord && names.empty() ? this->Block.Lines : this->Comment;
      return;
    }
    this->Block.CommentLine = this->Block.CommentLine < 0 ? this->Comment : this->Block.CommentLine;
    if (this->Block.FirstLine < 0)
    {
      this->Block.FirstLine = this->Block.Lines;
    }
    if (this->Block.EndLine >= 0)
    {
      this->Fail(LinesAfterEnd);
      return;
    }
    if (IsEndMark(line))
    {
      this->Block.EndLine = this->Block.Lines;
      return;
    }
    if (this->Layout.WhereColumn >= 0 && !this->Layout.IsChosen(line))
    {
      ++this->Block.OtherLines;
      return;
    }
    this->ParsePick(line);
  }

  void ParsePick(std::string_view line)
  {
    FieldCursor fields(line, this->Layout.Separator);
    std::size_t column = 0;
    std::string_view field;
    while (fields.Next(field))
    {
      if (column < this->Layout.Columns.size() && !this->ParseField(column, field))
      {
        return;
      }
      ++column;
    }
    if (column + 1 == this->Layout.Columns.size() && fields.EndsInSeparator())
    {
      if (!this->ParseField(column, ""))
      {
        return;
      }
      ++column;
    }
    const bool mayHaveMore = this->Layout.Kind == TextKind::Charisma; // Some programs add flags.
    if (column < this->Used || (column > this->Layout.Columns.size() && !mayHaveMore))
    {
      const bool mayBeSkipped = column > this->Layout.Columns.size() || column >= this->Layout.CountUsed(false);
      this->Fail(std::to_string(column) + " fields, expected one for each of the columns " +
        ListNames(this->Layout.Columns) +
        (mayBeSkipped ? ": if lines lack some at the end, Columns skips these by -" : ""));
      return;
    }
    if (this->IsEndOfLine())
    {
      this->DropLast();
      return;
    }
    const std::int64_t offset = this->Block.Lines - std::int64_t(this->Picks);
    if (this->Block.PickLines.empty() || offset != this->Offset)
    {
      this->Block.PickLines.push_back({ this->Picks, this->Block.Lines });
      this->Offset = offset;
    }
    ++this->Picks;
  }

  /// RMS ends lines and files by a point whose coordinates are all 999; other programs use other null values.
  bool IsEndOfLine() const
  {
    if (this->X < 0 || this->Y < 0)
    {
      return false;
    }
    const auto last = [this](int column) { return this->Block.Values[std::size_t(column)].back(); };
    const double x = last(this->X);
    const bool isMark = std::abs(x) == 999.0 || std::abs(x) == 9999.0 || this->Layout.Nulls.IsNullNumber(x);
    return isMark && last(this->Y) == x && (last(this->Z) == x || std::isnan(last(this->Z)));
  }

  void DropLast()
  {
    for (std::vector<double>& values : this->Block.Values)
    {
      if (!values.empty())
      {
        values.pop_back();
      }
    }
    if (!this->Block.Horizon.empty())
    {
      this->Block.Horizon.pop_back();
    }
  }

  bool ParseField(std::size_t column, std::string_view field)
  {
    const FieldRole role = this->Layout.Columns[column].Role;
    if (role == FieldRole::Ignored)
    {
      return true;
    }
    if (role == FieldRole::HorizonName)
    {
      return this->ParseName(field);
    }
    const bool mayBeNull = role == FieldRole::Z || role == FieldRole::Attribute;
    double value = NoValue;
    const bool isNumber = IsFinite(field, value);
    if (!isNumber && !this->Layout.Nulls.IsNullText(field))
    {
      const bool isDecimal = field.find(',') != std::string_view::npos &&
        std::all_of(field.begin(), field.end(), [](char c) { return IsDigit(c) || c == ',' || c == '-'; });
      this->Fail(Quote(field) + " as " + RoleWord(role) +
        (isDecimal      ? ", expected a decimal point: replace the commas"
            : mayBeNull ? ", expected a number; NullValues lists words for no value"
                        : ", expected a number"));
      return false;
    }
    if (!isNumber || (mayBeNull && this->Layout.Nulls.IsNullNumber(value)))
    {
      if (isNumber && role == FieldRole::Z && this->Layout.AreNullsUsual)
      {
        this->Block.Nulls.push_back(value);
      }
      value = NoValue;
    }
    if (!isNumber && !mayBeNull)
    {
      this->Fail(Quote(field) + " as " + RoleWord(role) +
        ", expected a number: only Z and attributes may be missing; "
        "Where chooses lines of one kind");
      return false;
    }
    this->Block.Values[column].push_back(value);
    return true;
  }

  bool ParseName(std::string_view name)
  {
    if (std::any_of(name.begin(), name.end(), IsControl))
    {
      this->Fail(Quote(name) + " as name of a horizon, expected characters that can be printed");
      return false;
    }
    if (name.empty())
    {
      this->Fail("no name of a horizon, expected one in each line: leave the column out in Columns, or fill it");
      return false;
    }
    this->Block.Horizon.push_back(this->NumberOfName(name));
    return true;
  }

  int NumberOfName(std::string_view name)
  {
    std::vector<std::string>& names = this->Block.Names;
    if (!this->Block.Horizon.empty() && names[std::size_t(this->Block.Horizon.back())] == name)
    {
      return this->Block.Horizon.back();
    }
    const auto [found, isNew] = this->Numbers.emplace(name, int(names.size()));
    if (isNew)
    {
      names.emplace_back(name);
    }
    return found->second;
  }

  void Fail(const std::string& text)
  {
    this->Block.ErrorLine = this->Block.Lines;
    this->Block.Error = text;
  }

  const TextLayout& Layout;
  const int X, Y, Z;
  const std::size_t Used;
  PickBlock Block;
  std::size_t Picks = 0;
  std::int64_t Comment = -1;
  std::int64_t Offset = 0; // Line of the last pick minus its number.
  std::unordered_map<std::string_view, int> Numbers;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::string WithDecimalPoints(std::string_view text)
{
  std::string points(text);
  for (std::size_t n = 1; n + 1 < points.size(); ++n)
  {
    if (points[n] == ',' && IsDigit(points[n - 1]) && IsDigit(points[n + 1]))
    {
      points[n] = '.';
    }
  }
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
PickBlock ParsePicks(std::string_view lines, const TextLayout& layout)
{
  if (layout.HasDecimalCommas)
  {
    return BlockParser(layout).Parse(WithDecimalPoints(lines));
  }
  return BlockParser(layout).Parse(lines);
}
}
