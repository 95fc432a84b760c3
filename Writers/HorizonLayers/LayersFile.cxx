// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayersFile.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/OutputFile.h"
#include "LayersPrinter.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr int MostLayers = 1 << 20; // Larger numbers mean something else.

const DataArray* FindCellNumbers(const VolumeGrid& grid, const char* name)
{
  const DataArray* const array = grid.CellData.Find(name);
  return array && !array->IsText() && array->Components() == 1 ? array : nullptr;
}

const DataArray& RequireArray(const VolumeGrid& grid, const char* name)
{
  const DataArray* const array = FindCellNumbers(grid, name);
  if (!array)
  {
    throw InputError(
      std::string("no cell data array ") + name + " of one number, expected layers as Horizon Layers makes them");
  }
  return *array;
}

void AddCorners(const VolumeGrid& grid, std::int64_t cell, VolumeCells& cells)
{
  const int type = int(grid.Types.At(cell));
  const std::int64_t expected = type == VolumeType::Wedge ? 6
    : type == VolumeType::Pyramid                         ? 5
    : type == VolumeType::Tetrahedron                     ? 4
                                                          : 0;
  if (expected == 0)
  {
    throw InputError("cell " + std::to_string(cell) + " of VTK type " + std::to_string(type) +
      ", expected wedges, pyramids and tetrahedra as Horizon Layers makes them");
  }
  const std::int64_t size = grid.Cells.Length(cell);
  if (size != expected)
  {
    throw InputError("cell " + std::to_string(cell) + " of VTK type " + std::to_string(type) + " with " +
      std::to_string(size) + " corners, expected " + std::to_string(expected));
  }
  for (std::int64_t n = 0; n < size; ++n)
  {
    cells.Corners.push_back(grid.Cells.At(cell, n));
  }
  cells.Ends.push_back(std::int64_t(cells.Corners.size()));
}

int NumberAt(const DataArray& array, std::int64_t cell, const char* what)
{
  const double number = array.At(cell);
  if (!(number >= 0.0 && number < MostLayers))
  {
    throw InputError(what + std::to_string(number) + " of cell " + std::to_string(cell) + ", expected 0 to " +
      std::to_string(MostLayers - 1));
  }
  return int(number);
}

void ReadCells(const VolumeGrid& grid, VolumeCells& cells, const Monitor& monitor)
{
  constexpr std::int64_t betweenReports = 1 << 16;
  const DataArray& layers = RequireArray(grid, CellArray::Layer);
  const DataArray& triangles = RequireArray(grid, CellArray::Triangle);
  const DataArray* const sublayers = FindCellNumbers(grid, CellArray::Sublayer);
  const DataArray* const faults = FindCellNumbers(grid, CellArray::FaultFaces);
  const std::int64_t size = grid.Cells.Size();
  for (std::int64_t cell = 0; cell < size; ++cell)
  {
    if (cell % betweenReports == 0)
    {
      monitor.Progress(double(cell) / double(size));
    }
    AddCorners(grid, cell, cells);
    cells.Layers.push_back(NumberAt(layers, cell, "layer "));
    cells.Sublayers.push_back(sublayers ? NumberAt(*sublayers, cell, "sublayer ") : 0);
    cells.Triangles.push_back(std::int64_t(triangles.At(cell)));
    cells.FaultFaces.push_back(faults ? static_cast<unsigned char>(NumberAt(*faults, cell, "faces ")) : 0);
  }
}

void ReadNames(const VolumeGrid& grid, VolumeCells& cells)
{
  const DataArray* const horizons = grid.FieldData.Find(FieldArray::HorizonNames);
  if (horizons && horizons->IsText())
  {
    cells.Horizons = horizons->Texts();
  }
  const DataArray* const names = grid.FieldData.Find(FieldArray::LayerNames);
  if (names && names->IsText())
  {
    cells.Names = names->Texts();
    return;
  }
  for (const int layer : cells.Layers)
  {
    while (layer >= int(cells.Names.size()))
    {
      cells.Names.push_back("Layer " + std::to_string(cells.Names.size() + 1));
    }
  }
}

VolumeCells ReadLayers(const VolumeGrid& grid, const Monitor& monitor)
{
  const std::int64_t points = grid.Places.Tuples();
  RequireTuples(grid.PointData, points, "points");
  RequireTuples(grid.CellData, grid.Cells.Size(), "cells");
  VolumeCells cells;
  if (grid.Cells.Size() > 0)
  {
    ReadCells(grid, cells, monitor);
  }
  ReadNames(grid, cells);
  cells.Points.resize(std::size_t(points));
  for (std::int64_t point = 0; point < points; ++point)
  {
    cells.Points[std::size_t(point)] = { grid.Places.At(point, 0), grid.Places.At(point, 1), grid.Places.At(point, 2) };
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

//----------------------------------------------------------------------------------------------------------------------
LayerBoundary FindBoundary(const VolumeGrid& grid)
{
  return FindBoundary(ReadLayers(grid, Monitor()));
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLayersFile(const std::string& path, const VolumeGrid& grid, const Monitor& monitor)
{
  const std::string format = ExtensionOf(path);
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
    cells.LengthUnit = LengthUnitOf(ReadSurveyFields(grid.FieldData));
  }
  WriteOutputFile(path, [&](std::ostream& stream) { print(cells, stream, monitor.Step(0.2, 1.0)); });
}
}
