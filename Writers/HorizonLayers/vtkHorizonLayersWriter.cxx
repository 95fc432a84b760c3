// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonLayersWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/OutputFile.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/SurveyFields.h"
#include "LayersPrinter.h"
#include "Writers/XMLPrinter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <string>

using namespace SeismicHorizons;

namespace
{
constexpr int MostLayers = 1 << 20; // Larger numbers mean something else.

vtkDataArray* RequireArray(vtkUnstructuredGrid* grid, const char* name)
{
  vtkDataArray* const array = grid->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw InputError(
      std::string("no cell data array ") + name + " of one number, expected layers as Horizon Layers makes them");
  }
  return array;
}

void AddCorners(vtkUnstructuredGrid* grid, vtkIdType cell, VolumeCells& cells)
{
  const int type = grid->GetCellType(cell);
  const vtkIdType expected = type == VTK_WEDGE ? 6 : type == VTK_PYRAMID ? 5 : type == VTK_TETRA ? 4 : 0;
  if (expected == 0)
  {
    throw InputError("cell " + std::to_string(cell) + " of VTK type " + std::to_string(type) +
      ", expected wedges, pyramids and tetrahedra as Horizon Layers makes them");
  }
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  grid->GetCells()->GetCellAtId(cell, size, corners);
  if (size != expected)
  {
    throw InputError("cell " + std::to_string(cell) + " of VTK type " + std::to_string(type) + " with " +
      std::to_string(size) + " corners, expected " + std::to_string(expected));
  }
  cells.Corners.insert(cells.Corners.end(), corners, corners + size);
  cells.Ends.push_back(std::int64_t(cells.Corners.size()));
}

void ReadCells(vtkUnstructuredGrid* grid, VolumeCells& cells, const Monitor& monitor)
{
  constexpr vtkIdType betweenReports = 1 << 16;
  vtkDataArray* const layers = RequireArray(grid, CellArray::Layer);
  vtkDataArray* const triangles = RequireArray(grid, CellArray::Triangle);
  const vtkIdType size = grid->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    if (cell % betweenReports == 0)
    {
      monitor.Progress(double(cell) / double(size));
    }
    AddCorners(grid, cell, cells);
    const double layer = layers->GetComponent(cell, 0);
    if (!(layer >= 0.0 && layer < MostLayers))
    {
      throw InputError("layer " + std::to_string(layer) + " of cell " + std::to_string(cell) + ", expected 0 to " +
        std::to_string(MostLayers - 1));
    }
    cells.Layers.push_back(int(layer));
    cells.Triangles.push_back(std::int64_t(triangles->GetComponent(cell, 0)));
  }
}

void ReadNames(vtkUnstructuredGrid* grid, VolumeCells& cells)
{
  auto* const names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(FieldArray::LayerNames));
  for (vtkIdType n = 0; names && n < names->GetNumberOfValues(); ++n)
  {
    cells.Names.push_back(names->GetValue(n));
  }
  for (const int layer : cells.Layers)
  {
    while (!names && layer >= int(cells.Names.size()))
    {
      cells.Names.push_back("Layer " + std::to_string(cells.Names.size() + 1));
    }
  }
}

VolumeCells ReadLayers(vtkUnstructuredGrid* grid, const Monitor& monitor)
{
  RequireTuples(grid->GetPointData(), grid->GetNumberOfPoints(), "points");
  RequireTuples(grid->GetCellData(), grid->GetNumberOfCells(), "cells");
  VolumeCells cells;
  if (grid->GetNumberOfCells() > 0)
  {
    ReadCells(grid, cells, monitor);
  }
  ReadNames(grid, cells);
  cells.Points.resize(std::size_t(grid->GetNumberOfPoints()));
  for (std::size_t point = 0; point < cells.Points.size(); ++point)
  {
    grid->GetPoint(vtkIdType(point), cells.Points[point].data());
  }
  CheckCells(cells);
  return cells;
}

/// Flow needs lengths along all axes.
std::string LengthUnitOf(const SurveyDescription& survey)
{
  if (survey.VerticalDomain == "time")
  {
    throw InputError("layers in time, expected depths: convert the horizons before");
  }
  const std::string& unit = survey.HorizontalUnit.empty() ? survey.VerticalUnit : survey.HorizontalUnit;
  if (!survey.HorizontalUnit.empty() && !survey.VerticalUnit.empty() && survey.HorizontalUnit != survey.VerticalUnit)
  {
    throw InputError(
      "z in " + survey.VerticalUnit + " and x and y in " + survey.HorizontalUnit + ", expected one unit");
  }
  return unit == "m" ? "METERS" : unit == "ft" ? "FEET" : "";
}
}

vtkStandardNewMacro(vtkHorizonLayersWriter);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonLayersWriter::~vtkHorizonLayersWriter()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonLayersWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonLayersWriter::WriteData()
{
  const std::string file = this->FileName ? this->FileName : "";
  const auto write = [&](std::string& subject, const Monitor& monitor)
  {
    if (file.empty())
    {
      throw FileError(FileProblem::NoName, "no FileName, expected the path of a file");
    }
    subject = file;
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
    vtkMultiProcessController* const processes = vtkMultiProcessController::GetGlobalController();
    if (processes && processes->GetLocalProcessId() > 0 && grid->GetNumberOfCells() == 0)
    {
      return; // The first process has all data.
    }
    const std::string format = ExtensionOf(file);
    if (format == "vtu") // This format holds any cells.
    {
      WriteOutputFile(file, [&](std::ostream& stream) { PrintXML<vtkXMLUnstructuredGridWriter>(grid, stream); });
      return;
    }
    const auto print = format == "msh" ? PrintGmsh
      : format == "inp"                ? PrintAbaqus
      : format == "disv"               ? PrintDISV
                                       : nullptr;
    if (!print)
    {
      throw InputError("extension \"" + format + "\", expected vtu, msh, inp or disv");
    }
    VolumeCells cells = ReadLayers(grid, monitor.Step(0.0, 0.2));
    if (format == "disv")
    {
      cells.LengthUnit = LengthUnitOf(ReadSurveyFields(grid->GetFieldData()));
    }
    WriteOutputFile(file, [&](std::ostream& stream) { print(cells, stream, monitor.Step(0.2, 1.0)); });
  };
  RunRequest(this, {}, file + ": more data than memory, expected fewer layers", write, Ranks(), &this->ErrorCode);
}
