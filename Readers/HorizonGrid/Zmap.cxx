// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/LineErrors.h"
#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
struct ZmapHeader
{
  std::string Name;
  int Width = 0; // Characters of a value, for files without separators.
  NullRule IsNull;
  std::string NullText; // for files without a null number
  int Decimals = 0; // Implied decimals of values without a point.
  int FirstCharacter = 1; // Character from 1 at which the values of a line begin.
  SurveyLattice Lattice;
};

std::string_view FindLine(GridText& text, const std::string& expected)
{
  for (; text.PeekLine(); text.NextLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    if (!line.empty() && line.front() != '!')
    {
      return line;
    }
  }
  throw text.EndError(expected);
}

HeaderFields ReadFields(GridText& text, const std::string& expected)
{
  const std::string_view line = FindLine(text, expected);
  HeaderFields fields(text.Place(), SplitAtCommas(line));
  text.NextLine();
  return fields;
}

/// The name is the text before ", GRID", often followed by the word HEADER.
std::string ReadName(GridText& text)
{
  const std::string_view line = FindLine(text, "@ and a name");
  std::string name(Trim(line.substr(1, line.find(',') - 1)));
  constexpr std::string_view word = "HEADER";
  if (name.size() >= word.size() && name.compare(name.size() - word.size(), word.size(), word) == 0)
  {
    name.resize(name.size() - word.size());
  }
  text.NextLine();
  return std::string(Trim(name));
}

void ReadNull(const HeaderFields& fields, ZmapHeader& header)
{
  if (!fields.Text(1, "null value").empty())
  {
    header.IsNull = NullAt(fields.Number(1, "null value"));
  }
  else
  {
    header.NullText = fields.Text(2, "null text");
  }
}

int ReadWhole(const HeaderFields& fields, std::size_t index, const std::string& name, int least)
{
  const std::string word = index < fields.Size() ? fields.Text(index, name) : std::string();
  return word.empty() || word == std::to_string(least) ? least : fields.Count(index, name);
}

ZmapHeader ReadZmapHeader(GridText& text)
{
  ZmapHeader header;
  header.Name = ReadName(text);
  const HeaderFields layout = ReadFields(text, "width of values");
  header.Width = layout.Count(0, "width of values");
  ReadNull(layout, header);
  header.Decimals = ReadWhole(layout, 3, "number of decimals", 0);
  header.FirstCharacter = ReadWhole(layout, 4, "first character", 1);
  const HeaderFields extent = ReadFields(text, "ny, nx, xmin, xmax, ymin, ymax");
  const std::array<int, 2> columns = { extent.Count(1, "nx"), extent.Count(0, "ny") };
  const std::array<double, 2> x = { extent.Number(2, "xmin"), extent.Number(3, "xmax") };
  const std::array<double, 2> y = { extent.Number(4, "ymin"), extent.Number(5, "ymax") };
  header.Lattice = PrefixErrors(extent.Place(), [&] { return AxisLattice(columns, x, y); });
  while (FindLine(text, "@ behind the header").front() != '@')
  {
    text.NextLine();
  }
  text.NextLine();
  return header;
}

/// Only the width may separate values.
class ZmapValues
{
public:
  ZmapValues(GridText& text, const ZmapHeader& header)
    : Text(text)
    , Header(header)
    , Count(CountNodes(header.Lattice.Columns))
  {
    this->Values.reserve(text.Room(this->Count));
  }

  std::vector<double> Read()
  {
    for (; this->Found() < this->Count; this->Text.NextLine())
    {
      const std::optional<std::string_view> line = this->Text.PeekLine();
      if (!line)
      {
        throw this->Text.EndError(this->Found(), this->Count);
      }
      this->ReadLine(*line);
    }
    this->Text.RequireEnd();
    this->SetPoint();
    return std::move(this->Values);
  }

private:
  std::int64_t Found() const { return static_cast<std::int64_t>(this->Values.size()); }

  void ReadLine(std::string_view line)
  {
    const char* text = SkipBlanks(line.data());
    if (*text == '!' || *text == '+')
    {
      return;
    }
    const std::size_t before = this->Values.size();
    while (*text != '\n')
    {
      const std::string_view word = TokenAt(text);
      if (this->IsSeveral(word))
      {
        this->Values.resize(before);
        this->ReadColumns(line);
        return;
      }
      this->Take(word);
      text = SkipBlanks(text + word.size());
    }
  }

  /// Adjacent values form a word wider than one value, without exactly one point.
  bool IsSeveral(std::string_view word) const
  {
    return word.size() > static_cast<std::size_t>(this->Header.Width) && std::count(word.begin(), word.end(), '.') != 1;
  }

  void ReadColumns(std::string_view line)
  {
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    const auto width = static_cast<std::size_t>(this->Header.Width);
    for (auto first = static_cast<std::size_t>(this->Header.FirstCharacter - 1); first < line.size(); first += width)
    {
      this->Take(Trim(line.substr(first, width)));
    }
  }

  void Take(std::string_view word)
  {
    if (this->Found() == this->Count)
    {
      throw this->Text.Error(Quote(word) + " after the last value, expected the end of the file");
    }
    const bool isNull = !this->Header.NullText.empty() && word == this->Header.NullText;
    const double z = isNull ? std::numeric_limits<double>::quiet_NaN() : this->ReadValue(word);
    this->Values.push_back(z);
    if (this->Header.Decimals > 0 && !std::isnan(z) && z != 0.0)
    {
      this->NotePoint(word);
    }
  }

  double ReadValue(std::string_view word) const
  {
    double z = 0.0;
    if (ReadPlainNumber(word.data(), z) == word.data() + word.size())
    {
      return this->Header.IsNull(z) ? std::numeric_limits<double>::quiet_NaN() : z;
    }
    return ReadGridValue(word, this->Header.IsNull, this->Text);
  }

  /// Values without a point have implied decimals, as in Fortran. The meaning of a mixture is unknown.
  void NotePoint(std::string_view word)
  {
    const bool hasPoint = word.find_first_of(".eEdD") != std::string_view::npos;
    if (this->HasPoint.value_or(hasPoint) != hasPoint)
    {
      throw this->Text.Error("value " + Quote(word) + (hasPoint ? " with" : " without") +
        " a point, expected one in all values or in none as the header says " + std::to_string(this->Header.Decimals) +
        " decimals");
    }
    this->HasPoint = hasPoint;
  }

  void SetPoint()
  {
    if (!this->HasPoint.value_or(true))
    {
      const double scale = std::pow(10.0, this->Header.Decimals);
      for (double& z : this->Values)
      {
        z /= scale;
      }
    }
  }

  GridText& Text;
  const ZmapHeader& Header;
  const std::int64_t Count;
  std::vector<double> Values;
  std::optional<bool> HasPoint;
};
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadZmap(GridText& text)
{
  HorizonGrid grid;
  const ZmapHeader header = ReadZmapHeader(text);
  grid.Name = header.Name;
  grid.Lattice = header.Lattice;
  grid.Z = Arrange(ZmapValues(text, header).Read(), grid.Lattice.Columns, ColumnsFromTop);
  return grid;
}
}
