// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/PlaneFit.h"
#include "Common/Survey/SurveyDescription.h"
#include "Common/Survey/SurveyLattice.h"
#include "Common/Survey/Units.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextNumbers.h"
#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
struct GridPoint
{
  Eigen::Vector2d Place = Eigen::Vector2d::Zero();
  double Z = 0.0;
  int I = 0;
  int J = 0;
  std::int64_t Line = 0;
};

constexpr double SmallestStepSine = 0.01; // of the angle between the steps; surveys are nearly rectangular

void RequireArea(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  if (!(std::fabs(i.x() * j.y() - i.y() * j.x()) > SmallestStepSine * i.norm() * j.norm()))
  {
    throw InputError("columns and rows of nodes along the same line of x and y, expected a lattice in the plane");
  }
}

void RequireOnNodes(const std::vector<GridPoint>& points, const SurveyLattice& lattice)
{
  const double step = std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm());
  for (const GridPoint& point : points)
  {
    const Eigen::Vector2d node = lattice.Origin + point.I * lattice.ColumnStep + point.J * lattice.RowStep;
    const double shift = (point.Place - node).norm();
    if (!(shift <= LargestNodeShift * step))
    {
      throw ErrorAt(point.Line,
        "a point " + ShortestText(shift) + " from its node, expected a regular lattice with points within " +
          ShortestText(LargestNodeShift * step));
    }
  }
}

/// Distances from the first point are summed, so that large coordinates lose no digits.
/// Throws InputError if all points are on one line, or a point is far from its node.
SurveyLattice FitGridLattice(const std::vector<GridPoint>& points, const std::array<int, 2>& columns)
{
  PlaneFit fit;
  for (const GridPoint& point : points)
  {
    fit.Add({ point.I - points[0].I, point.J - points[0].J }, point.Place - points[0].Place);
  }
  const std::optional<PlaneMap> map = fit.Solve();
  if (!map)
  {
    throw InputError(
      std::to_string(points.size()) + " points along one line of nodes, expected some off this line");
  }
  SurveyLattice lattice;
  lattice.Columns = columns;
  lattice.ColumnStep = map->Steps.col(0);
  lattice.RowStep = map->Steps.col(1);
  lattice.Origin = points[0].Place + map->Origin - points[0].I * lattice.ColumnStep - points[0].J * lattice.RowStep;
  RequireArea(lattice);
  RequireOnNodes(points, lattice);
  return lattice;
}

struct EarthVisionField
{
  std::string Name;
  std::size_t Index = 0;
};

struct EarthVisionHeader
{
  SurveyDescription Survey;
  EarthVisionField X, Y, Z, Column, Row;
  std::array<int, 2> Columns = {}; // Nodes along i and j; 0 if not stated.
  std::optional<double> Null;
};

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
  grid.Lattice = FitGridLattice(points, columns);
  grid.Z = PlaceValues(points, columns);
  return grid;
}
}
