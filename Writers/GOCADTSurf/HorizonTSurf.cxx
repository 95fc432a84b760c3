// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTSurf.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/SurveyFields.h"
#include "Writers/HorizonSampling.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExpectedTriangles = ", expected triangles: apply Triangulate first";

std::vector<std::array<double, 3>> ReadVertices(vtkPolyData* horizon, double upwards)
{
  if (horizon->GetNumberOfPoints() > std::numeric_limits<PointId>::max())
  {
    throw InputError(std::to_string(horizon->GetNumberOfPoints()) + " points, expected less than 2^31");
  }
  std::vector<std::array<double, 3>> vertices(std::size_t(horizon->GetNumberOfPoints()));
  for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
  {
    horizon->GetPoint(vtkIdType(vertex), vertices[vertex].data());
    vertices[vertex][2] *= upwards;
  }
  return vertices;
}

TSurf::Triangle ToTriangle(std::size_t polygon, vtkIdType size, const vtkIdType* corners, vtkIdType numberOfPoints)
{
  if (size != 3)
  {
    throw InputError(
      "polygon " + std::to_string(polygon) + " with " + std::to_string(size) + " corners" + ExpectedTriangles);
  }
  for (vtkIdType n = 0; n < size; ++n)
  {
    if (corners[n] < 0 || corners[n] >= numberOfPoints)
    {
      throw InputError("triangle " + std::to_string(polygon) + " has the corner " + std::to_string(corners[n]) +
        ", expected points from 0 to " + std::to_string(numberOfPoints - 1));
    }
  }
  return { PointId(corners[0]), PointId(corners[1]), PointId(corners[2]) };
}

/// Triangles are reversed if z is, so that they keep their orientation.
std::vector<TSurf::Triangle> ReadTurnedTriangles(vtkPolyData* horizon, bool isTurned)
{
  if (horizon->GetNumberOfStrips() > 0)
  {
    throw InputError(std::to_string(horizon->GetNumberOfStrips()) + " triangle strips" + ExpectedTriangles);
  }
  if (horizon->GetNumberOfPolys() == 0)
  {
    throw InputError(std::to_string(horizon->GetNumberOfPoints()) +
      " points without triangles, expected a mesh, as the triangulation makes it; leave out horizons of one line");
  }
  std::vector<TSurf::Triangle> triangles;
  triangles.reserve(std::size_t(horizon->GetNumberOfPolys()));
  const auto polygon = vtk::TakeSmartPointer(horizon->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    polygon->GetCurrentCell(size, corners);
    TSurf::Triangle triangle = ToTriangle(triangles.size(), size, corners, horizon->GetNumberOfPoints());
    if (isTurned)
    {
      std::swap(triangle[1], triangle[2]);
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<std::int32_t> ReadParts(vtkPolyData* horizon)
{
  auto* const parts = vtkIntArray::SafeDownCast(horizon->GetCellData()->GetArray(CellArray::Part));
  if (!parts || parts->GetNumberOfComponents() != 1)
  {
    return {};
  }
  RequireTuples(parts, horizon->GetNumberOfCells(), "cells");
  // Polygons follow vertices and lines in cell data.
  const vtkIdType first = horizon->GetNumberOfVerts() + horizon->GetNumberOfLines();
  std::vector<std::int32_t> numbers;
  for (vtkIdType cell = first; cell < first + horizon->GetNumberOfPolys(); ++cell)
  {
    numbers.push_back(parts->GetValue(cell));
  }
  return numbers;
}

TSurfProperty ReadProperty(vtkDataArray* array)
{
  TSurfProperty property;
  property.Name = array->GetName();
  property.Size = std::size_t(array->GetNumberOfComponents());
  if (array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
  {
    property.Unit = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  }
  vtkNew<vtkDoubleArray> values;
  values->DeepCopy(array);
  property.Values.assign(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
  return property;
}

}

//----------------------------------------------------------------------------------------------------------------------
TSurf MakeTSurf(vtkPolyData* horizon, const std::string& name, VerticalPositive positive)
{
  const bool isDepth = positive == VerticalPositive::Depth;
  TSurf surface;
  surface.Name = name;
  surface.Positive = positive;
  surface.Survey = ReadSurveyFields(horizon->GetFieldData());
  surface.Triangles = ReadTurnedTriangles(horizon, isDepth);
  surface.Parts = ReadParts(horizon);
  surface.Vertices = ReadVertices(horizon, isDepth ? -1.0 : 1.0);
  vtkDataArray* const colour = horizon->GetFieldData()->GetArray(FieldArray::Colour);
  if (colour && colour->GetNumberOfComponents() == 3 && colour->GetNumberOfTuples() > 0)
  {
    surface.Colour = { colour->GetComponent(0, 0), colour->GetComponent(0, 1), colour->GetComponent(0, 2) };
  }
  return surface;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TSurfProperty> ReadProperties(vtkPolyData* horizon, bool withOwn)
{
  std::vector<TSurfProperty> properties;
  vtkPointData* const data = horizon->GetPointData();
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const array = data->GetArray(n);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (!name.empty() && name != vtkDataSetAttributes::GhostArrayName() && (withOwn || !IsOwnArray(name)))
    {
      properties.push_back(ReadProperty(array));
    }
  }
  return properties;
}
}
