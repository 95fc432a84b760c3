// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EarthVisionHeader.h"

#include "Common/Survey/Units.h"
#include "HeaderFields.h"

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t NoIndex = static_cast<std::size_t>(-1);

void ReadField(const HeaderFields& words, EarthVisionHeader& header)
{
  const auto index = static_cast<std::size_t>(words.Count(0, "number of a field") - 1);
  const std::string& name = words.Text(1, "name of a field");
  for (EarthVisionField* const field : { &header.X, &header.Y, &header.Z, &header.Column, &header.Row })
  {
    if (IsSameWord(name, field->Name))
    {
      field->Index = index;
    }
  }
  if (IsSameWord(name, header.Z.Name) && words.Size() > 2)
  {
    SetVerticalUnit(header.Survey, words.Text(2, "unit"));
  }
}

/// The text is "281 x 441" or "281x441".
void ReadSize(const std::string& place, std::string value, EarthVisionHeader& header)
{
  for (char& c : value)
  {
    c = c == 'x' || c == 'X' ? ' ' : c;
  }
  const HeaderFields words(place, SplitAtBlanks(value));
  header.Columns = { words.Count(0, "number of columns"), words.Count(1, "number of rows") };
}

void ReadKey(const std::string& place, std::string_view line, EarthVisionHeader& header)
{
  const std::size_t colon = std::min(line.find(':'), line.size());
  const std::string_view key = Trim(line.substr(0, colon));
  const std::string value(Trim(line.substr(std::min(colon + 1, line.size()))));
  if (IsSameWord(key, "Field"))
  {
    ReadField(HeaderFields(place, SplitAtBlanks(value)), header);
  }
  else if (IsSameWord(key, "Grid_size"))
  {
    ReadSize(place, value, header);
  }
  else if (IsSameWord(key, "Null_value"))
  {
    header.Null = ReadHeaderNumber(value, "null value", place);
  }
  else if (IsSameWord(key, "Projection"))
  {
    header.Survey.CoordinateSystem = value;
  }
  else if (IsSameWord(key, "Units"))
  {
    header.Survey.HorizontalUnit = ShortUnit(value);
  }
  else if (IsSameWord(key, "Z_units"))
  {
    SetVerticalUnit(header.Survey, value);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
EarthVisionHeader ReadEarthVisionHeader(GridText& text)
{
  EarthVisionHeader header;
  header.X = { "x", NoIndex };
  header.Y = { "y", NoIndex };
  header.Z = { "z", NoIndex };
  header.Column = { "column", NoIndex };
  header.Row = { "row", NoIndex };
  for (; text.PeekLine(); text.NextLine())
  {
    const std::string_view line = Trim(*text.PeekLine());
    if (!line.empty() && line.front() != '#')
    {
      break;
    }
    ReadKey(text.Place(), line.substr(line.empty() ? 0 : 1), header);
  }
  for (const EarthVisionField& field : { header.X, header.Y, header.Z, header.Column, header.Row })
  {
    if (field.Index == NoIndex)
    {
      throw text.Error("no field " + field.Name + ", expected it before the values");
    }
  }
  return header;
}
}
