// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/LineErrors.h"
#include "EarthVisionHeader.h"
#include "GridParsers.h"
#include "HeaderFields.h"
#include "NodeFit.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double LeastNull = 1e20; // if the header states no other value

class EarthVisionPoints
{
public:
  EarthVisionPoints(GridText& text, const EarthVisionHeader& header)
    : Text(text)
    , Header(header)
    , IsNull(OrFrom(header.Null ? NullAt(*header.Null) : NullRule(), LeastNull))
  {
  }

  std::vector<GridPoint> Read()
  {
    for (; this->Text.PeekLine(); this->Text.NextLine())
    {
      if (this->SplitLine(*this->Text.PeekLine()))
      {
        this->ReadPoint();
      }
    }
    return std::move(this->Points);
  }

private:
  bool SplitLine(std::string_view line)
  {
    this->Words.clear();
    const char* text = SkipBlanks(line.data());
    const bool isComment = *text == '#';
    while (*text != '\n' && !isComment)
    {
      this->Words.push_back(TokenAt(text));
      text = SkipBlanks(text + this->Words.back().size());
    }
    return !this->Words.empty();
  }

  std::string_view Word(const EarthVisionField& field) const
  {
    if (field.Index >= this->Words.size())
    {
      throw this->Text.Error(std::to_string(this->Words.size()) + " values, expected a number " +
        std::to_string(field.Index + 1) + ", " + field.Name);
    }
    return this->Words[field.Index];
  }

  double Number(const EarthVisionField& field) const
  {
    double value = 0.0;
    const std::string_view word = this->Word(field);
    return ReadPlainNumber(word.data(), value) ? value : ReadHeaderNumber(word, field.Name, this->Text.Place());
  }

  int NodeNumber(const EarthVisionField& field, int last) const
  {
    const std::string_view word = this->Word(field);
    const int number = ReadHeaderCount(word, field.Name, this->Text.Place());
    if (last > 0 && number > last)
    {
      throw this->Text.Error(field.Name + ' ' + Quote(word) + ", expected at most " + std::to_string(last));
    }
    return number;
  }

  void ReadPoint()
  {
    GridPoint point;
    point.Z = ReadGridValue(this->Word(this->Header.Z), this->IsNull, this->Text);
    if (std::isnan(point.Z))
    {
      return;
    }
    point.Place = { this->Number(this->Header.X), this->Number(this->Header.Y) };
    point.I = this->NodeNumber(this->Header.Column, this->Header.Columns[0]) - 1;
    point.J = this->NodeNumber(this->Header.Row, this->Header.Columns[1]) - 1;
    point.Line = this->Text.Line();
    this->Points.push_back(point);
  }

  GridText& Text;
  const EarthVisionHeader& Header;
  const NullRule IsNull;
  std::vector<GridPoint> Points;
  std::vector<std::string_view> Words;
};

/// Headers without sizes get the smallest lattice that contains all points.
std::array<int, 2> FindColumns(const EarthVisionHeader& header, const std::vector<GridPoint>& points)
{
  std::array<int, 2> columns = header.Columns;
  for (const GridPoint& point : points)
  {
    columns = { std::max(columns[0], point.I + 1), std::max(columns[1], point.J + 1) };
  }
  return columns;
}

std::vector<double> PlaceValues(const std::vector<GridPoint>& points, const std::array<int, 2>& columns)
{
  std::vector<double> z(static_cast<std::size_t>(CountNodes(columns)), std::numeric_limits<double>::quiet_NaN());
  for (const GridPoint& point : points)
  {
    double& value = z[static_cast<std::size_t>(point.I + std::int64_t(point.J) * columns[0])];
    if (!std::isnan(value))
    {
      throw ErrorAt(point.Line,
        "second point at column " + std::to_string(point.I + 1) + " and row " + std::to_string(point.J + 1) +
          ", expected one for each node");
    }
    value = point.Z;
  }
  return z;
}
}

//----------------------------------------------------------------------------------------------------------------------
/// The lattice is fitted to the points, because programs describe it differently in headers.
HorizonGrid ReadEarthVision(GridText& text)
{
  HorizonGrid grid;
  const EarthVisionHeader header = ReadEarthVisionHeader(text);
  grid.Survey = header.Survey;
  const std::vector<GridPoint> points = EarthVisionPoints(text, header).Read();
  const std::array<int, 2> columns = FindColumns(header, points);
  RequirePoints(CountNodes(columns), static_cast<std::int64_t>(points.size()));
  grid.Lattice = FitLattice(points, columns);
  grid.Z = PlaceValues(points, columns);
  return grid;
}
}
