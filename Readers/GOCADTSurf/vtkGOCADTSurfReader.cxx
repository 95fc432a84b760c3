// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGOCADTSurfReader.h"

#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/TSurf.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/SurveyFields.h"
#include "TSurfParser.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
vtkSmartPointer<vtkPoints> MakeSurfaceVertices(const TSurf& surface)
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

vtkSmartPointer<vtkCellArray> MakeSurfaceCells(const TSurf& surface)
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

/// Arrays are described in Documentation/GOCADTSurfReader.md. If z of the file increases downwards, triangles are
/// reversed with it and keep their orientation.
vtkSmartPointer<vtkPolyData> MakeTSurfDataSet(TSurf surface)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(MakeSurfaceVertices(surface));
  data->SetPolys(MakeSurfaceCells(surface));
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
}

namespace
{
using namespace SeismicHorizons;

std::vector<std::string> NamesOf(const TSurfList& list)
{
  std::vector<std::string> names = list.Names;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    if (names[n].empty())
    {
      names[n] = "TSurf " + std::to_string(n + 1);
    }
  }
  return names;
}

/// Where z grows to, and why.
std::string DescribeSense(const std::vector<TSurf>& surfaces)
{
  const auto isDown = [](const TSurf& surface) { return surface.Positive == VerticalPositive::Depth; };
  const auto down = std::count_if(surfaces.begin(), surfaces.end(), isDown);
  const bool isSaid = std::any_of(surfaces.begin(), surfaces.end(), [](const TSurf& s) { return s.HasPositive; });
  const char* const way = down == 0 ? "upwards" : "downwards";
  return std::string("z increases ") + way +
    (down > 0 && down < std::ptrdiff_t(surfaces.size()) ? " in some surfaces" : "") +
    (isSaid ? ", as ZPOSITIVE of the file says" : ", as nothing in the file says otherwise");
}
}

// ---- The class ---------------------------------------------------------------------------------------------------
struct vtkGOCADTSurfReader::FileList
{
  FileStamp Stamp;
  std::vector<std::string> Names;
  std::vector<std::int64_t> Lines;
};

vtkStandardNewMacro(vtkGOCADTSurfReader);

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::vtkGOCADTSurfReader() = default;

//----------------------------------------------------------------------------------------------------------------------
vtkGOCADTSurfReader::~vtkGOCADTSurfReader() = default;

//----------------------------------------------------------------------------------------------------------------------
int vtkGOCADTSurfReader::CanReadFile(const char* fileName)
{
  const bool isOwn = ExtensionOf(fileName ? fileName : "") == "ts";
  return IsRecognised(fileName,
    [isOwn](std::istream& stream)
    {
      const std::optional<std::string> type = FirstTypeOfGOCAD(stream);
      return type && (isOwn || *type != "pline");
    });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkGOCADTSurfReader::ListHorizons(const Monitor& monitor)
{
  RequireFileName(this->Files.GetCurrent());
  PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const FileStamp stamp = MakeFileStamp(this->Files.GetCurrent());
      if (!this->List || !(this->List->Stamp == stamp))
      {
        this->List.reset();
        const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
        TSurfList found = ListTSurfs(*stream, monitor);
        this->List = std::make_unique<FileList>(FileList{ stamp, NamesOf(found), std::move(found.Lines) });
      }
    });
  return this->List->Names;
}

//----------------------------------------------------------------------------------------------------------------------
/// Lines estimate sizes, since vertices are known only after reading.
std::vector<std::int64_t> vtkGOCADTSurfReader::CountHorizonPoints()
{
  return this->List->Lines;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkGOCADTSurfReader::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  const auto isChosen = [&numbers](std::size_t number)
  { return std::binary_search(numbers.begin(), numbers.end(), static_cast<int>(number)); };
  std::vector<TSurf> surfaces = PrefixFileErrors(this->Files.GetCurrent(),
    [&]()
    {
      const std::unique_ptr<std::istream> stream = OpenInputFile(this->Files.GetCurrent());
      return LoadTSurfs(*stream, isChosen, monitor.Step(0.0, 0.9));
    });
  this->Description = DescribeSense(surfaces);
  std::vector<vtkSmartPointer<vtkDataObject>> datasets;
  for (TSurf& surface : surfaces)
  {
    // Moving frees each surface after its conversion.
    datasets.push_back(MakeTSurfDataSet(std::move(surface)));
    monitor.Progress(0.9 + 0.1 * static_cast<double>(datasets.size()) / static_cast<double>(surfaces.size()));
  }
  return datasets;
}
