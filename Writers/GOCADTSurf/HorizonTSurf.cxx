// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTSurf.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "TSurfPrinter.h"
#include "Writers/FaultParts.h"
#include "Writers/HorizonSampling.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExpectedTriangles = ", expected triangles: apply Triangulate first";

std::vector<std::array<double, 3>> ReadVertices(const Horizon& horizon, double upwards)
{
  if (horizon.NumberOfPoints() > std::numeric_limits<PointId>::max())
  {
    throw InputError(std::to_string(horizon.NumberOfPoints()) + " points, expected less than 2^31");
  }
  std::vector<std::array<double, 3>> vertices(std::size_t(horizon.NumberOfPoints()));
  for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
  {
    const Eigen::Vector3d place = horizon.Place(std::int64_t(vertex));
    vertices[vertex] = { place.x(), place.y(), place.z() * upwards };
  }
  return vertices;
}

TSurf::Triangle ToTriangle(const Horizon& horizon, std::int64_t polygon)
{
  const std::int64_t size = horizon.Polygons.Length(polygon);
  if (size != 3)
  {
    throw InputError(
      "polygon " + std::to_string(polygon) + " with " + std::to_string(size) + " corners" + ExpectedTriangles);
  }
  TSurf::Triangle triangle = {};
  for (std::size_t n = 0; n < triangle.size(); ++n)
  {
    const std::int64_t corner = horizon.Polygons.At(polygon, std::int64_t(n));
    if (corner < 0 || corner >= horizon.NumberOfPoints())
    {
      throw InputError("triangle " + std::to_string(polygon) + " has the corner " + std::to_string(corner) +
        ", expected points from 0 to " + std::to_string(horizon.NumberOfPoints() - 1));
    }
    triangle[n] = PointId(corner);
  }
  return triangle;
}

/// Triangles are reversed if z is, so that they keep their orientation.
std::vector<TSurf::Triangle> ReadTurnedTriangles(const Horizon& horizon, bool isTurned)
{
  if (horizon.Strips > 0)
  {
    throw InputError(std::to_string(horizon.Strips) + " triangle strips" + ExpectedTriangles);
  }
  if (horizon.Polygons.Size() == 0)
  {
    throw InputError(std::to_string(horizon.NumberOfPoints()) +
      " points without triangles, expected a mesh, as the triangulation makes it; leave out horizons of one line");
  }
  std::vector<TSurf::Triangle> triangles;
  triangles.reserve(std::size_t(horizon.Polygons.Size()));
  for (std::int64_t polygon = 0; polygon < horizon.Polygons.Size(); ++polygon)
  {
    TSurf::Triangle triangle = ToTriangle(horizon, polygon);
    if (isTurned)
    {
      std::swap(triangle[1], triangle[2]);
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<std::int32_t> ReadParts(const Horizon& horizon)
{
  const DataArray* const parts = horizon.CellData.Find(CellArray::Part);
  if (!parts || !parts->As<int>() || parts->Components() != 1)
  {
    return {};
  }
  RequireTuples(*parts, horizon.NumberOfCells(), "cells");
  // Polygons follow vertices and lines in cell data.
  const int* const first = parts->As<int>() + horizon.Vertices.Size() + horizon.Lines.Size();
  return { first, first + horizon.Polygons.Size() };
}

TSurfProperty ReadProperty(const DataArray& array)
{
  TSurfProperty property;
  property.Name = array.Name;
  property.Size = std::size_t(array.Components());
  property.Unit = array.Unit;
  array.WithNumbers([&](const auto* numbers) { property.Values.assign(numbers, numbers + array.Size()); });
  return property;
}

std::string FirstGiven(const std::string& option, const std::string& field)
{
  return option.empty() ? field : option;
}
}

//----------------------------------------------------------------------------------------------------------------------
TSurf MakeTSurf(const Horizon& horizon, const std::string& name, VerticalPositive positive)
{
  const bool isDepth = positive == VerticalPositive::Depth;
  TSurf surface;
  surface.Name = name;
  surface.Positive = positive;
  surface.Survey = ReadSurveyFields(horizon.FieldData);
  surface.Triangles = ReadTurnedTriangles(horizon, isDepth);
  surface.Parts = ReadParts(horizon);
  surface.Vertices = ReadVertices(horizon, isDepth ? -1.0 : 1.0);
  const DataArray* const colour = horizon.FieldData.Find(FieldArray::Colour);
  if (colour && !colour->IsText() && colour->Components() == 3 && colour->Tuples() > 0)
  {
    surface.Colour = { colour->At(0, 0), colour->At(0, 1), colour->At(0, 2) };
  }
  return surface;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TSurfProperty> ReadProperties(const Horizon& horizon, bool withOwn)
{
  std::vector<TSurfProperty> properties;
  for (const DataArray& array : horizon.PointData)
  {
    const bool isNamed = !array.IsText() && !array.Name.empty() && array.Name != PointArray::Ghosts;
    if (isNamed && (withOwn || !IsOwnArray(array.Name)))
    {
      properties.push_back(ReadProperty(array));
    }
  }
  return properties;
}

//----------------------------------------------------------------------------------------------------------------------
void PrintTSurfs(
  const std::vector<NamedHorizon>& given, const TSurfOptions& options, std::ostream& stream, const Monitor& monitor)
{
  const std::vector<NamedHorizon> horizons = SplitByFault(given);
  const std::vector<std::string> names = MakeDistinct(NamesOf(horizons));
  const auto size = double(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    PrefixErrors(names[n],
      [&]()
      {
        const Horizon& horizon = horizons[n].Data;
        TSurf surface = MakeTSurf(horizon, names[n], options.Positive);
        if (options.Arrays != WrittenArrays::None)
        {
          surface.Properties = ReadProperties(horizon, options.Arrays == WrittenArrays::All);
        }
        SurveyDescription& survey = surface.Survey;
        survey.VerticalUnit = FirstGiven(options.Survey.VerticalUnit, survey.VerticalUnit);
        survey.HorizontalUnit = FirstGiven(options.Survey.HorizontalUnit, survey.HorizontalUnit);
        survey.CoordinateSystem = FirstGiven(options.Survey.CoordinateSystem, survey.CoordinateSystem);
        PrintTSurf(surface, options.WithBorders, stream, monitor.Step(double(n) / size, double(n + 1) / size));
      });
  }
}
}
