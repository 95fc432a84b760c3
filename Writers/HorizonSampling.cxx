// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSampling.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/MeshSampling.h"
#include "Common/Survey/SurveyFields.h"
#include "Filters/Common/HorizonData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 14> OwnArrays = { PointArray::SurfaceId, PointArray::Column, PointArray::Elevation,
  PointArray::VerticalIndex, PointArray::RealZ, PointArray::PatchId, PointArray::Boundary, PointArray::PointCount,
  PointArray::CellOrigin, PointArray::Flatness, PointArray::Distance, PointArray::VerticalDistance, PointArray::Filled,
  PointArray::Spike };

void CheckLines(const LineNumbering& lines)
{
  const Eigen::Vector4d numbers(lines.FirstInline, lines.InlineStep, lines.FirstCrossline, lines.CrosslineStep);
  if (!numbers.allFinite() || lines.InlineStep == 0.0 || lines.CrosslineStep == 0.0)
  {
    throw InputError("LineNumbers " + ToText(numbers) + ", expected finite numbers, and steps other than 0");
  }
}

SurveyLattice ReadSurveyLattice(const Horizon& horizon)
{
  ReadLattice(horizon); // Refuses horizons without a valid lattice.
  const std::array<int, 3> size = ReadLatticeDimensions(horizon);
  SurveyLattice lattice = MakeLatticeFrame(size, ReadLatticeMap(horizon), VerticalDirection::Up).Lattice;
  const DataArray* const lines = horizon.FieldData.Find(FieldArray::LineNumbers);
  if (lines && !lines->IsText() && lines->Size() == 4)
  {
    lattice.Lines = LineNumbering{ lines->Value(2), lines->Value(3), lines->Value(0), lines->Value(1) };
    CheckLines(*lattice.Lines);
  }
  return lattice;
}

bool IsAttribute(const DataArray& array)
{
  return array.IsFloating() && !array.Name.empty() && array.Components() == 1 && !IsOwnArray(array.Name);
}

void SamplePoints(const Horizon& horizon, int sign, HorizonColumns& columns)
{
  const LatticePoints points = ReadColumns(horizon, KeptHeights::None);
  std::vector<std::size_t> places; // index of each point
  for (const PlanePoint& column : points.Column)
  {
    const std::size_t place = columns.Tiles.Place(column.X, column.Y);
    columns.Z.resize(columns.Tiles.Size(), NoValue);
    columns.Z[place] = sign * horizon.Places.At(std::int64_t(places.size()), 2);
    places.push_back(place);
  }
  for (const DataArray& array : horizon.PointData)
  {
    if (IsAttribute(array))
    {
      PickAttribute& attribute = columns.Attributes.emplace_back();
      attribute.Name = array.Name;
      attribute.Values.resize(columns.Z.size(), NoValue);
      for (std::size_t point = 0; point < places.size(); ++point)
      {
        attribute.Values[places[point]] = array.At(std::int64_t(point));
      }
    }
  }
}

void SampleTriangles(const Horizon& horizon, int sign, HorizonColumns& columns, const Monitor& monitor)
{
  const Lattice lattice = ReadLattice(horizon);
  std::vector<SpacePoint> points;
  for (std::int64_t point = 0; point < horizon.NumberOfPoints(); ++point)
  {
    const Eigen::Vector3d place = lattice.ToLattice(horizon.Place(point));
    points.push_back({ place.x(), place.y(), place.z() });
  }
  MeshSampling sampling(columns.Lattice.Columns);
  sampling.AddTriangles(points, ReadTriangles(horizon), monitor);
  for (double& height : sampling.Heights)
  {
    height = sign * lattice.ToWorld({ 0.0, 0.0, height }).z();
  }
  sampling.AddBarePoints(points, [&](std::size_t point) { return sign * horizon.Places.At(std::int64_t(point), 2); });
  columns.Tiles = std::move(sampling.Tiles);
  columns.Z = std::move(sampling.Heights);
}

// The larger of both limits applies to the columns of a grid.
constexpr std::int64_t EnoughGridColumns = 1 << 22; // They take 32 MB, and about 40 MB in a file.
constexpr std::int64_t MostColumnsPerValue = 10000;

void RequireDense(const std::array<int, 3>& dimensions, const std::vector<double>& z)
{
  const std::int64_t columns = std::int64_t(dimensions[0]) * dimensions[1];
  const std::int64_t values =
    std::int64_t(z.size()) - std::count_if(z.begin(), z.end(), [](double value) { return std::isnan(value); });
  if (values == 0)
  {
    throw InputError(
      "no column under the triangles, expected at least one: set shorter column and row steps, unless this is a "
      "steep fault");
  }
  if (columns > std::max(EnoughGridColumns, MostColumnsPerValue * values))
  {
    throw InputError("lattice of " + std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) +
      " columns, of which the horizon has " + std::to_string(values) +
      ", expected at least one in 10000 for a grid file, which lists all; a text file lists those of the horizon");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsOwnArray(const std::string& name)
{
  return std::find(OwnArrays.begin(), OwnArrays.end(), name) != OwnArrays.end();
}

//----------------------------------------------------------------------------------------------------------------------
int VerticalSign(const Horizon& horizon, WrittenSense sense)
{
  if (sense != WrittenSense::AsRead)
  {
    return sense == WrittenSense::Depth ? -1 : 1;
  }
  const DataArray* const direction = horizon.FieldData.Find(FieldArray::VerticalDirection);
  return direction && !direction->IsText() && direction->Size() == 1 && direction->Value(0) < 0.0 ? -1 : 1;
}

//----------------------------------------------------------------------------------------------------------------------
int SignOfTable(const Horizon& horizon, WrittenSense sense)
{
  const int sign = VerticalSign(horizon, sense);
  bool isAbove = sign < 0 && sense == WrittenSense::AsRead;
  for (std::int64_t point = 0; isAbove && point < horizon.NumberOfPoints(); ++point)
  {
    isAbove = horizon.Place(point).z() >= 0.0;
  }
  return isAbove ? 1 : sign;
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t CountColumns(int columns, int rows, std::int64_t points)
{
  const std::int64_t count = std::int64_t(columns) * rows;
  if (count > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError("lattice of " + std::to_string(columns) + " x " + std::to_string(rows) +
      " columns, expected less than 2^31 in all for a file that lists them; the horizon has " + std::to_string(points) +
      " points");
  }
  return std::size_t(count);
}

//----------------------------------------------------------------------------------------------------------------------
HorizonColumns SampleHorizon(const Horizon& horizon, int sign, const Monitor& monitor)
{
  monitor.Progress(0.0);
  HorizonColumns columns;
  columns.Lattice = ReadSurveyLattice(horizon);
  columns.Survey = ReadSurveyFields(horizon.FieldData);
  if (horizon.Polygons.Size() > 0)
  {
    SampleTriangles(horizon, sign, columns, monitor);
  }
  else
  {
    SamplePoints(horizon, sign, columns);
  }
  return columns;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid SampleWholeLattice(const Horizon& horizon, int sign, const Monitor& monitor)
{
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  const std::size_t nodes = CountColumns(dimensions[0], dimensions[1], horizon.NumberOfPoints());
  const HorizonColumns sampled = SampleHorizon(horizon, sign, monitor);
  RequireDense(dimensions, sampled.Z);
  HorizonGrid grid;
  grid.Survey = sampled.Survey;
  grid.Lattice = sampled.Lattice;
  grid.Z.assign(nodes, NoValue);
  sampled.Tiles.ForEachPlace(
    [&](int i, int j, std::size_t place)
    {
      if (!std::isnan(sampled.Z[place]))
      {
        grid.Z[std::size_t(i) + std::size_t(j) * std::size_t(dimensions[0])] = sampled.Z[place];
      }
    });
  return grid;
}
}
