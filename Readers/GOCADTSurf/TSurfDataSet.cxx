// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TSurfDataSet.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/SurveyFields.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
vtkSmartPointer<vtkPoints> MakePoints(const TSurf& surface)
{
  const double upwards = surface.Positive == VerticalPositive::Depth ? -1.0 : 1.0;
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(surface.Vertices.size()));
  double* place = coordinates->GetPointer(0);
  for (const auto& [x, y, z] : surface.Vertices)
  {
    *place++ = x;
    *place++ = y;
    *place++ = upwards * z;
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

vtkSmartPointer<vtkCellArray> MakeTriangles(const TSurf& surface)
{
  const bool isTurned = surface.Positive == VerticalPositive::Depth;
  const auto size = static_cast<vtkIdType>(surface.Triangles.size());
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * size);
  auto* corner = corners->GetPointer(0);
  for (const auto& [a, b, c] : surface.Triangles)
  {
    *corner++ = a;
    *corner++ = isTurned ? c : b;
    *corner++ = isTurned ? b : c;
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(3, corners);
  return triangles;
}

/// Frees each property after copying it.
void AddProperties(std::vector<TSurfProperty>& properties, vtkPointData* data)
{
  std::vector<std::string> names(properties.size());
  std::transform(
    properties.begin(), properties.end(), names.begin(), [](const TSurfProperty& property) { return property.Name; });
  names = MakeDistinct(std::move(names));
  for (std::size_t n = 0; n < properties.size(); ++n)
  {
    TSurfProperty& property = properties[n];
    const auto size = static_cast<vtkIdType>(property.Values.size() / property.Size);
    auto array = NewArray<vtkDoubleArray>(names[n].c_str(), size, static_cast<int>(property.Size));
    std::copy(property.Values.begin(), property.Values.end(), array->GetPointer(0));
    property.Values = std::vector<double>();
    if (!property.Unit.empty())
    {
      array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), property.Unit.c_str());
    }
    data->AddArray(array);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTSurfDataSet(TSurf surface)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(MakePoints(surface));
  data->SetPolys(MakeTriangles(surface));
  AddProperties(surface.Properties, data->GetPointData());
  if (!surface.Parts.empty())
  {
    AddArray<vtkIntArray>(data->GetCellData(), CellArray::Part, surface.Parts);
  }
  vtkFieldData* const fields = data->GetFieldData();
  const bool isDown = surface.Positive == VerticalPositive::Depth;
  AddValue<vtkIntArray>(fields, FieldArray::VerticalDirection, isDown ? -1 : 1);
  AddSurveyFields(surface.Survey, fields);
  if (surface.Colour)
  {
    AddTuple<vtkDoubleArray>(fields, FieldArray::Colour, *surface.Colour);
  }
  return data;
}
}
