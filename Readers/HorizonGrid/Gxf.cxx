// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/Units.h"
#include "Common/Text/LineErrors.h"
#include "GridLayout.h"
#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

namespace SeismicHorizons
{
namespace
{
struct GxfHeader
{
  StorageOrder Order;
  NullRule IsNull;
  int GroupSize = 0; // Characters of a compressed value; 0 for plain numbers.
  double Scale = 1.0;
  double Offset = 0.0;
};

constexpr int LargestGroup = 9; // Digits in base 90 that fit a 64-bit integer.

struct GxfEntry
{
  std::string Place;
  std::string Text;
};

using GxfEntries = std::map<std::string, GxfEntry>;

/// A backslash at the end continues an entry on the next line.
GxfEntry ReadEntry(GridText& text)
{
  GxfEntry entry = { text.Place(), {} };
  bool goesOn = true;
  while (goesOn && text.PeekLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    goesOn = !line.empty() && line.back() == '\\';
    entry.Text += std::string(line.substr(0, line.size() - goesOn)) + ' ';
    text.NextLine();
  }
  return entry;
}

/// The value is on the line after its label; other lines are comments.
GxfEntries ReadEntries(GridText& text)
{
  GxfEntries entries;
  std::string label;
  while (text.PeekLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    if (!line.empty() && line.front() == '#')
    {
      label = ToLower(line.substr(1));
      text.NextLine();
      if (label == "grid")
      {
        return entries;
      }
    }
    else if (!label.empty() && (line.empty() || line.front() != '!'))
    {
      entries.insert_or_assign(label, ReadEntry(text));
      label.clear();
    }
    else
    {
      text.NextLine();
    }
  }
  throw text.EndError("#GRID");
}

class GxfFields
{
public:
  GxfFields(const GxfEntries& entries, const GridText& text)
    : Entries(entries)
    , Text(text)
  {
  }

  /// Labels are matched by their first letters, because some programs truncate them.
  std::optional<HeaderFields> Find(const std::string& label) const
  {
    const GxfEntry* const entry = this->FindEntry(label);
    return entry ? std::optional(HeaderFields(entry->Place, SplitAtBlanksAndCommas(entry->Text))) : std::nullopt;
  }

  double Number(const std::string& label, double usual) const
  {
    const std::optional<HeaderFields> fields = this->Find(label);
    return fields ? fields->Number(0, '#' + label) : usual;
  }

  int Count(const std::string& label) const
  {
    const std::optional<HeaderFields> fields = this->Find(label);
    if (!fields)
    {
      throw this->Text.Error("no #" + label + ", expected it before the values");
    }
    return fields->Count(0, '#' + label);
  }

  std::string Phrase(const std::string& label) const
  {
    const GxfEntry* const entry = this->FindEntry(label);
    const std::string_view text = entry ? Trim(entry->Text) : std::string_view();
    return !text.empty() && text.front() == '"' ? SplitAtBlanks(text)[0] : std::string(text);
  }

  std::string Word(const std::string& label) const
  {
    const std::optional<HeaderFields> fields = this->Find(label);
    return fields ? fields->Text(0, label) : std::string();
  }

  SurveyLattice Lattice(const std::array<int, 2>& columns, const std::array<double, 2>& steps, double degrees) const
  {
    const Eigen::Vector2d origin(this->Number("XORIGIN", 0.0), this->Number("YORIGIN", 0.0));
    return PrefixErrors(this->Text.Place(), [&] { return TurnedLattice(columns, origin, steps, degrees); });
  }

private:
  const GxfEntry* FindEntry(const std::string& name) const
  {
    const std::string label = ToLower(name);
    constexpr std::size_t lettersToTell = 5; // Five letters distinguish MAP_PROJECTION from MAP_DATUM.
    for (const auto& [found, entry] : this->Entries)
    {
      if (found.substr(0, lettersToTell) == label.substr(0, lettersToTell) || found == label.substr(0, 4))
      {
        return &entry;
      }
    }
    return nullptr;
  }

  const GxfEntries& Entries;
  const GridText& Text;
};

/// The sense gives the first node and the direction from it: 1 lower left, to the right; 2 upper left, down; 3 upper
/// right, to the left; 4 lower right, up. A negative sense goes from the same corner along the other axis.
StorageOrder ReadOrder(const GxfFields& fields, const GridText& text)
{
  const double sense = fields.Number("SENSE", 1.0);
  const double corner = std::fabs(sense);
  if (corner != 1.0 && corner != 2.0 && corner != 3.0 && corner != 4.0)
  {
    throw text.Error("#SENSE " + ShortestText(sense) + ", expected 1 to 4 or -4 to -1");
  }
  const bool isOddCorner = corner == 1.0 || corner == 3.0;
  StorageOrder order;
  order.AlongY = (sense < 0.0) == isOddCorner;
  order.FromTop = corner == 2.0 || corner == 3.0;
  order.FromRight = corner >= 3.0;
  return order;
}

/// Returns the corners with the least and the largest coordinates.
std::array<Eigen::Vector2d, 2> FindGxfExtent(const SurveyLattice& lattice)
{
  const Eigen::Vector2d x = (lattice.Columns[0] - 1) * lattice.ColumnStep;
  const Eigen::Vector2d y = (lattice.Columns[1] - 1) * lattice.RowStep;
  return { lattice.Origin + x.cwiseMin(0.0) + y.cwiseMin(0.0), lattice.Origin + x.cwiseMax(0.0) + y.cwiseMax(0.0) };
}

/// By the standard the origin is the first node, and the rotation is counterclockwise from x. OpenWorks writes the
/// corner of the bounding box and adds 90 degrees, which applies if only that fits ##XMAX and ##YMAX.
SurveyLattice ReadGxfLattice(const GxfFields& fields, const StorageOrder& order)
{
  std::array<int, 2> columns = { fields.Count("POINTS"), fields.Count("ROWS") };
  std::array<double, 2> steps = { fields.Number("PTSEPARATION", 1.0), fields.Number("RWSEPARATION", 1.0) };
  if (order.AlongY)
  {
    std::swap(columns[0], columns[1]);
    std::swap(steps[0], steps[1]);
  }
  const double rotation = fields.Number("ROTATION", 0.0);
  const SurveyLattice standard = fields.Lattice(columns, steps, rotation);
  if (!fields.Find("#XMAX") || !fields.Find("#YMAX"))
  {
    return standard;
  }
  SurveyLattice other = fields.Lattice(columns, steps, rotation - 90.0);
  other.Origin += other.Origin - FindGxfExtent(other)[0];
  const Eigen::Vector2d corner(fields.Number("#XMAX", 0.0), fields.Number("#YMAX", 0.0));
  const double halfStep = 0.5 * std::min(std::fabs(steps[0]), std::fabs(steps[1]));
  const auto fits = [&](const SurveyLattice& lattice)
  { return (FindGxfExtent(lattice)[1] - corner).cwiseAbs().maxCoeff() < halfStep; };
  return fits(other) && !fits(standard) ? other : standard;
}

int ReadGroupSize(const GxfFields& fields, const GridText& text)
{
  const double size = fields.Number("GTYPE", 0.0);
  if (size != std::floor(size) || size < 0.0 || size > LargestGroup)
  {
    throw text.Error("#GTYPE " + ShortestText(size) + ", expected 0 to " + std::to_string(LargestGroup));
  }
  return static_cast<int>(size);
}

GxfHeader ReadGxfHeader(GridText& text, HorizonGrid& grid)
{
  GxfHeader header;
  const GxfEntries entries = ReadEntries(text);
  const GxfFields fields(entries, text);
  grid.Name = fields.Phrase("TITLE");
  grid.Survey.HorizontalUnit = ShortUnit(fields.Word("UNIT_LENGTH"));
  grid.Survey.CoordinateSystem = fields.Phrase("MAP_PROJECTION");
  header.Order = ReadOrder(fields, text);
  grid.Lattice = ReadGxfLattice(fields, header.Order);
  header.GroupSize = ReadGroupSize(fields, text);
  if (fields.Find("DUMMY"))
  {
    header.IsNull = NullAt(fields.Number("DUMMY", 0.0));
  }
  if (const std::optional<HeaderFields> transform = fields.Find("TRANSFORM"))
  {
    header.Scale = transform->Number(0, "#TRANSFORM");
    header.Offset = transform->Number(1, "the offset of #TRANSFORM");
  }
  return header;
}

constexpr int Base = 90;
constexpr char Zero = '%'; // The other digits follow in ASCII.
constexpr char ValuelessGroup = '!'; // starts a group without value
constexpr char Repeat = '"'; // Groups with a count and with the repeated value follow.

/// Values in base 90 have no separators.
class CompressedValues
{
public:
  CompressedValues(GridText& text, const GxfHeader& header, std::int64_t count)
    : Text(text)
    , Header(header)
    , Count(count)
    , GroupSize(static_cast<std::size_t>(header.GroupSize))
  {
  }

  std::vector<double> Read()
  {
    while (this->Found() < this->Count)
    {
      const std::string_view group = this->NextGroup();
      const bool isRepeated = group.front() == Repeat;
      const std::int64_t times = isRepeated ? this->ReadRepeat() : 1;
      this->Append(times, isRepeated ? this->NextGroup() : group);
    }
    if (!this->Rest.empty())
    {
      throw this->Text.Error(Quote(this->Rest) + " after the last value, expected the end of the line");
    }
    this->Text.NextLine();
    return std::move(this->Values);
  }

private:
  std::int64_t Found() const { return static_cast<std::int64_t>(this->Values.size()); }

  std::string_view NextGroup()
  {
    while (this->Rest.empty())
    {
      if (!this->IsFirstLine)
      {
        this->Text.NextLine();
      }
      this->IsFirstLine = false;
      const std::optional<std::string_view> line = this->Text.PeekLine();
      if (!line)
      {
        throw this->Text.EndError(this->Found(), this->Count);
      }
      this->Rest = Trim(*line);
    }
    const std::string_view group = this->Rest.substr(0, this->GroupSize);
    if (group.size() < this->GroupSize)
    {
      throw this->Text.Error(Quote(group) + " at the end of the line, expected groups of " +
        std::to_string(this->GroupSize) + " characters");
    }
    this->Rest.remove_prefix(this->GroupSize);
    ++this->Groups;
    return group;
  }

  std::int64_t Decode(std::string_view group) const
  {
    std::int64_t number = 0;
    for (const char c : group)
    {
      if (c < Zero || c >= Zero + Base)
      {
        throw this->Text.Error("value " + Quote(group) + ", expected digits to the base 90");
      }
      number = Base * number + (c - Zero);
    }
    return number;
  }

  std::int64_t ReadRepeat()
  {
    const std::int64_t times = this->Decode(this->NextGroup());
    if (times > this->Count - this->Found())
    {
      throw this->Text.Error(
        "a value " + std::to_string(times) + " times, expected at most " + std::to_string(this->Count - this->Found()));
    }
    PrefixErrors(this->Text.Place(), [&] { RequirePoints(this->Found() + times, this->Groups); });
    return times;
  }

  void Append(std::int64_t times, std::string_view group)
  {
    const double z = group.front() == ValuelessGroup
      ? std::numeric_limits<double>::quiet_NaN()
      : static_cast<double>(this->Decode(group)) * this->Header.Scale + this->Header.Offset;
    if (std::isinf(z))
    {
      throw this->Text.Error("value " + Quote(group) + ", expected a finite number after #TRANSFORM");
    }
    this->Values.insert(this->Values.end(), static_cast<std::size_t>(times), z);
  }

  GridText& Text;
  const GxfHeader& Header;
  const std::int64_t Count;
  const std::size_t GroupSize;
  std::string_view Rest;
  bool IsFirstLine = true;
  std::int64_t Groups = 0;
  std::vector<double> Values;
};

std::vector<double> ReadPlainValues(GridText& text, const GxfHeader& header, std::int64_t count)
{
  std::vector<double> values = text.Values(count, header.IsNull);
  for (double& z : values)
  {
    z = z * header.Scale + header.Offset;
    if (std::isinf(z))
    {
      throw text.Error("a value too large, expected a finite number after #TRANSFORM");
    }
  }
  return values;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadGxf(GridText& text)
{
  HorizonGrid grid;
  const GxfHeader header = ReadGxfHeader(text, grid);
  const std::int64_t count = CountNodes(grid.Lattice.Columns);
  std::vector<double> values =
    header.GroupSize > 0 ? CompressedValues(text, header, count).Read() : ReadPlainValues(text, header, count);
  text.RequireEnd("#!");
  grid.Z = Arrange(std::move(values), grid.Lattice.Columns, header.Order);
  return grid;
}
}
