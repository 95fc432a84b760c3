// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables of points, with a line between fault lines or columns that tell them apart: CPS-3, IRAP and RMS, Kingdom,
// OpendTect, DUG, spreadsheets; and sticks of Charisma.

#include "FaultLineFormats.h"

#include "Common/Text/TextFields.h"
#include "FaultColumns.h"
#include "Readers/HorizonText/PickBlock.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace SeismicHorizons
{
namespace
{
class PlainLineParser : public FaultLineParser
{
public:
  PlainLineParser(FaultColumns columns, NullValues nulls)
    : Columns(std::move(columns))
    , Nulls(std::move(nulls))
  {
    this->File.IsUpright = this->Columns.IsUpright;
    this->File.Columns = this->Columns.Describe();
    this->File.Survey = this->Columns.Survey;
    for (std::size_t axis = 0; axis < this->Place.size(); ++axis)
    {
      this->Place[axis] = std::size_t(this->Columns.Find(FaultRole(std::size_t(FaultRole::X) + axis)));
    }
    this->Fault = this->Columns.Find(FaultRole::Fault);
    this->Stick = this->Columns.Find(FaultRole::Stick);
    this->Node = this->Columns.Find(FaultRole::Node);
  }

  void Take(const NumberedLine& line) override
  {
    const std::string_view text = Trim(line.Text);
    if (StartsWith(text, "->"))
    {
      this->EndLine();
      this->Name = std::string(Trim(text.substr(2)));
    }
    else if (line.Number <= this->Columns.HeaderLines || StartsWith(text, "FFA"))
    {
      return;
    }
    else if (SeparatesFaultLines(text))
    {
      this->EndLine();
    }
    else if (!IsSkipped(text))
    {
      const std::string converted = this->Columns.HasDecimalCommas ? WithDecimalPoints(text) : std::string();
      this->TakeFields(
        SplitFields(converted.empty() ? text : std::string_view(converted), this->Columns.Separator), line.Number);
    }
  }

  FaultLineFile Finish() override
  {
    this->EndLine();
    this->SplitNames();
    return std::move(this->File);
  }

private:
  void EndLine()
  {
    this->File.Close(this->Name.empty() ? this->Key.first : this->Name, this->Key.second);
    this->HasPlace = false;
  }

  /// Names that end in a number, and are all different, are of sticks: "A 0", "A 1".
  void SplitNames()
  {
    const auto hasNumber = [](const std::string& name)
    {
      const std::size_t blank = name.rfind(' ');
      return blank != std::string::npos && blank > 0 && IsNumber(std::string_view(name).substr(blank + 1));
    };
    std::vector<std::string>& names = this->File.Names;
    const std::set<std::string> different(names.begin(), names.end());
    if (this->Stick >= 0 || different.size() < names.size() || !std::all_of(names.begin(), names.end(), hasNumber))
    {
      return;
    }
    for (std::size_t line = 0; line < names.size(); ++line)
    {
      const std::size_t blank = names[line].rfind(' ');
      this->File.Sticks[line] = names[line].substr(blank + 1);
      names[line].resize(blank);
    }
  }

  void TakeFields(const std::vector<std::string_view>& fields, std::int64_t line)
  {
    if (StartsWith(fields.front(), "INLINE") || StartsWith(fields.front(), "CROSSLINE"))
    {
      this->TakeStick(fields, line);
      return;
    }
    const std::size_t needed = std::max({ this->Place[0], this->Place[1], this->Place[2] }) + 1;
    if (fields.size() <
      std::max(needed, this->Columns.EndInName ? 0 : std::size_t(std::max(this->Fault, this->Stick) + 1)))
    {
      throw ErrorAt(line, std::to_string(fields.size()) + " fields, expected the columns " + this->Columns.Describe());
    }
    const auto field = [&fields](int column)
    { return column < 0 ? std::string() : WithoutDoubledQuotes(Trim(fields[std::size_t(column)])); };
    double node = 0.0;
    const bool hasNode = this->Node >= 0 && std::size_t(this->Node) < fields.size() &&
      ReadNumber(fields[std::size_t(this->Node)], node) == NumberKind::Finite;
    const Keys key = this->Columns.EndInName ? NameOf(fields, needed) : Keys(field(this->Fault), field(this->Stick));
    // Nodes of a stick may fall; a line that begins again has the number of its first node again.
    const bool isAgain = this->Stick < 0 ? node <= this->LastNode : node == this->FirstNode && node != this->LastNode;
    if (hasNode && this->HasPlace && isAgain)
    {
      this->EndLine();
    }
    this->FirstNode = !this->HasPlace || key != this->Key ? node : this->FirstNode;
    this->LastNode = node;
    this->TakePlace(fields, this->Place, key, line);
  }

  /// The fields are: INLINE- inline crossline x y z name stick. Names may contain blanks.
  void TakeStick(const std::vector<std::string_view>& fields, std::int64_t line)
  {
    constexpr std::size_t FewestFields = 8;
    if (fields.size() < FewestFields)
    {
      throw ErrorAt(line,
        std::to_string(fields.size()) +
          " fields of a fault stick, expected 8: INLINE-, inline, crossline, x, y, z, "
          "name and number");
    }
    this->TakePlace(fields, { 3, 4, 5 }, NameOf(fields, 6), line);
  }

  using Keys = std::pair<std::string, std::string>; // fault and stick

  /// Fields from `first` on are a name; the last one is the stick if it is a number.
  static Keys NameOf(const std::vector<std::string_view>& fields, std::size_t first)
  {
    const bool hasStick = fields.size() > first && IsNumber(fields.back());
    std::string name;
    for (std::size_t n = first; n < fields.size() - (hasStick ? 1 : 0); ++n)
    {
      name += (n > first ? " " : "") + std::string(fields[n]);
    }
    return { name, hasStick ? std::string(fields.back()) : std::string() };
  }

  void TakePlace(const std::vector<std::string_view>& fields, const std::array<std::size_t, 3>& at, const Keys& key,
    std::int64_t line)
  {
    double z = 0.0;
    const bool isNull = this->Nulls.IsNullText(fields[at[2]]) ||
      (ReadNumber(fields[at[2]], z) == NumberKind::Finite && this->Nulls.IsNullNumber(z));
    if (isNull)
    {
      ++this->File.WithoutZ;
      return;
    }
    const SpacePoint place = { ReadFinite(fields[at[0]], line, "x"), ReadFinite(fields[at[1]], line, "y"),
      ReadFinite(fields[at[2]], line, "z") };
    if (this->HasPlace && key != this->Key)
    {
      this->EndLine();
    }
    this->Key = key;
    this->HasPlace = true;
    this->File.Append(place);
  }

  FaultLineFile File;
  const FaultColumns Columns;
  const NullValues Nulls; // of z
  std::array<std::size_t, 3> Place = {};
  int Fault = -1;
  int Stick = -1;
  int Node = -1;
  double FirstNode = 0.0; // of the line
  double LastNode = 0.0;
  std::string Name;
  Keys Key;
  bool HasPlace = false;
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<FaultLineParser> MakePlainLineParser(const FaultColumns& columns, const NullValues& nulls)
{
  return std::make_unique<PlainLineParser>(columns, nulls);
}
}
