// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFaults.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/Faults/FaultDetection.h"
#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Marshalling/CutData.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/LatticePoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int LinesPort = 1;

// ---- Given lines ----------------------------------------------------------------------------------------------------

/// `first` is the cell id of the first cell.
void AppendCells(vtkPolyData* data, vtkCellArray* cells, vtkIdType first, std::vector<FaultStick>& polylines)
{
  const bool arePolygons = cells == data->GetPolys();
  auto* const names = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray(CellArray::FaultName));
  if (names)
  {
    RequireTuples(names, data->GetNumberOfCells(), "cells");
  }
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(cell, size, points);
    FaultStick polyline;
    for (vtkIdType n = 0; n < size; ++n)
    {
      if (points[n] < 0 || points[n] >= data->GetNumberOfPoints())
      {
        throw InputError("point id " + std::to_string(points[n]) + " in fault polyline " +
          std::to_string(polylines.size()) + ", expected 0 to " + std::to_string(data->GetNumberOfPoints() - 1));
      }
      const double* const place = data->GetPoint(points[n]);
      polyline.Places.push_back({ place[0], place[1], place[2] });
    }
    if (arePolygons && !polyline.Places.empty())
    {
      polyline.Places.push_back(polyline.Places.front());
    }
    if (names)
    {
      const std::string name = names->GetValue(first + cell);
      polyline.Fault = name.substr(0, name.rfind(' ')); // without the last word
    }
    polylines.push_back(polyline);
  }
}

void AppendDataSet(vtkDataObject* object, std::vector<FaultStick>& polylines)
{
  auto* const data = vtkPolyData::SafeDownCast(object);
  if (!data)
  {
    throw InputError(
      "fault polylines in a " + std::string(object->GetClassName()) + ", expected lines or polygons of a vtkPolyData");
  }
  AppendCells(data, data->GetLines(), data->GetNumberOfVerts(), polylines);
  AppendCells(data, data->GetPolys(), data->GetNumberOfVerts() + data->GetNumberOfLines(), polylines);
}

/// Polygons become closed polylines. Sticks of a fault have the same FaultName, apart from its last word, the number of
/// the stick, and are in the same dataset. Throws InputError on other datasets.
std::vector<FaultStick> ReadPolylines(vtkDataObject* lines)
{
  std::vector<FaultStick> polylines;
  auto* const composite = vtkCompositeDataSet::SafeDownCast(lines);
  if (!composite)
  {
    AppendDataSet(lines, polylines);
    return polylines;
  }
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    const std::size_t first = polylines.size();
    AppendDataSet(leaves->GetCurrentDataObject(), polylines);
    // Sticks in different datasets belong to different faults.
    const std::string number = std::to_string(leaves->GetCurrentFlatIndex());
    std::for_each(polylines.begin() + std::ptrdiff_t(first), polylines.end(),
      [&number](FaultStick& polyline) { polyline.Fault += ' ' + number; });
  }
  return polylines;
}

/// Heights are dropped.
std::vector<FaultPolyline> ToMap(const std::vector<FaultStick>& lines, const Lattice& lattice)
{
  std::vector<FaultPolyline> polylines;
  for (const FaultStick& line : lines)
  {
    polylines.emplace_back();
    for (const SpacePoint& world : line.Places)
    {
      const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(world.X, world.Y, world.Z));
      polylines.back().push_back({ place.x(), place.y() });
    }
  }
  return polylines;
}

/// Converts world coordinates to columns and vertical indices, in place.
void ToLattice(std::vector<FaultSheet>& sheets, const Lattice& lattice)
{
  for (FaultSheet& sheet : sheets)
  {
    for (std::optional<SpacePoint>& given : sheet.Places)
    {
      if (given)
      {
        const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(given->X, given->Y, given->Z));
        given = { place.x(), place.y(), place.z() };
      }
    }
  }
}

// ---- Output ---------------------------------------------------------------------------------------------------------

void WriteFaultSheets(const std::vector<FaultSheet>& sheets, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkStringArray> names;
  names->SetName(CellArray::FaultName);
  for (const FaultSheet& sheet : sheets)
  {
    std::vector<vtkIdType> ids(sheet.Places.size(), -1);
    for (const std::array<std::size_t, 3>& triangle : sheet.ListTriangles())
    {
      triangles->InsertNextCell(3);
      for (const std::size_t place : triangle)
      {
        const SpacePoint& at = *sheet.Places[place];
        ids[place] = ids[place] < 0 ? points->InsertNextPoint(at.X, at.Y, at.Z) : ids[place];
        triangles->InsertCellPoint(ids[place]);
      }
      names->InsertNextValue(sheet.Fault);
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetCellData()->AddArray(names);
}

MapPlace EndOf(const FaultedLink& cut, bool isLast)
{
  const double shift = cut.IsForward == isLast ? 0.5 : -0.5;
  const PlanePoint column = cut.Place.Column;
  return cut.Place.Side == LinkSide::East ? MapPlace{ column.X + 0.5, column.Y + shift }
                                          : MapPlace{ column.X + shift, column.Y + 0.5 };
}

/// A link without a height takes the previous one, or else the first known one, or else `otherwise`. Heights from one
/// side only, as at a hole, count only if no link of the line has both.
std::vector<double> FindHeights(const FaultLines& lines, std::size_t line, double otherwise)
{
  const std::size_t start = lines.Start(line);
  const std::size_t end = lines.End(line);
  bool hasBoth = false;
  for (std::size_t n = start; n < end; ++n)
  {
    hasBoth = hasBoth || !std::isnan(lines[n].Throw);
  }
  const auto heightOr = [&lines, hasBoth](std::size_t n, double last)
  { return std::isnan(hasBoth ? lines[n].Throw : lines[n].Middle) ? last : lines[n].Middle; };
  double last = otherwise;
  for (std::size_t n = end; n-- > start;)
  {
    last = heightOr(n, last);
  }
  std::vector<double> heights;
  for (std::size_t n = start; n < end; ++n)
  {
    last = heightOr(n, last);
    heights.push_back(last);
  }
  return heights;
}

/// A polyline runs through the middles of faulted links. Throw is positive where the left side of the line is higher.
/// Links without a height take one from their line, or else `height`.
void WriteFaultLines(const FaultLines& lines, const Lattice& lattice, double height, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> throws;
  throws->SetName(PointArray::Throw);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(CellArray::FaultLine);
  const auto append = [&](const MapPlace& place, double z, const FaultedLink& link)
  {
    cells->InsertCellPoint(points->InsertNextPoint(lattice.ToWorld(Eigen::Vector3d(place.X, place.Y, z)).data()));
    throws->InsertNextValue(link.LeftThrow());
  };
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    const std::size_t start = lines.Start(line);
    const std::size_t end = lines.End(line);
    assert(start < end);
    const std::vector<double> heights = FindHeights(lines, line, height);
    cells->InsertNextCell(int(end - start + 2));
    append(EndOf(lines[start], false), heights.front(), lines[start]);
    for (std::size_t n = start; n < end; ++n)
    {
      const PlanePoint before = lines[n].Place.Column;
      const PlanePoint beyond = lines[n].Place.Beyond();
      append({ 0.5 * (before.X + beyond.X), 0.5 * (before.Y + beyond.Y) }, heights[n - start], lines[n]);
    }
    append(EndOf(lines[end - 1], true), heights.back(), lines[end - 1]);
    numbers->InsertNextValue(int(line));
  }
  output->SetPoints(points);
  output->SetLines(cells);
  output->GetPointData()->AddArray(throws);
  output->GetPointData()->SetActiveScalars(PointArray::Throw);
  output->GetCellData()->AddArray(numbers);
}
}

vtkStandardNewMacro(vtkHorizonFaults);

//------------------------------------------------------------------------------
vtkHorizonFaults::vtkHorizonFaults()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
FaultDetectionOptions vtkHorizonFaults::MakeOptions() const
{
  FaultDetectionOptions options;
  options.SmallestThrow = this->SmallestThrow;
  options.Noise = this->Noise;
  options.SmallestExtent = this->SmallestExtent;
  options.SmallestBranch = this->SmallestBranch;
  options.LargestGap = this->LargestGap;
  options.LargestRamp = this->LargestRamp;
  options.JoinThroughHoles = this->JoinThroughHoles;
  return options;
}

//------------------------------------------------------------------------------
int vtkHorizonFaults::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->MeasuredNoise = 0.0;
  this->NumberOfFaultLines = 0;
  this->NumberOfFaultedLinks = 0;
  this->NumberOfGivenLines = 0;
  this->DoesGivenLineCut = false;
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (this->NumberOfGivenLines > 0 && !this->DoesGivenLineCut)
  {
    vtkWarningMacro("none of " << this->NumberOfGivenLines
                               << " fault polylines passes between columns of a horizon, expected lines in the "
                                  "coordinates of its points");
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkHorizonFaults::UsePolygons(std::vector<FaultPolyline>& polylines, LatticePoints& points, const Outputs& outputs)
{
  if (this->Polygons == Leave)
  {
    polylines.erase(std::remove_if(polylines.begin(), polylines.end(), IsClosed), polylines.end());
  }
  if (this->Polygons != Blank)
  {
    return;
  }
  const KeptPoints outside = FindOutside(points.Column, polylines);
  const std::size_t inside = points.Height.size() - outside.size();
  AddValue<vtkIdTypeArray>(outputs[0]->GetFieldData(), FieldArray::BlankedPoints, vtkIdType(inside));
  if (outside.empty())
  {
    throw InputError("fault polygons enclose all " + std::to_string(inside) + " points, expected some outside");
  }
  if (inside > 0)
  {
    this->DoesGivenLineCut = true;
    vtkNew<vtkPolyData> rest;
    CopyPoints(points.Horizon, outside, rest);
    rest->GetFieldData()->PassData(points.Horizon->GetFieldData());
    points = ReadColumns(rest, outputs);
  }
}

//------------------------------------------------------------------------------
void vtkHorizonFaults::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  FaultDetectionOptions options = this->MakeOptions();
  CheckOptions(options);
  LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkPolyData* const output = outputs[0];
  std::vector<FaultPolyline> polylines;
  vtkIdType givenLines = 0;
  if (vtkDataObject* const given = this->GetInputDataObject(LinesPort, 0))
  {
    const bool isFirst = this->NumberOfGivenLines == 0;
    const std::vector<FaultStick> lines = ReadPolylines(given);
    givenLines = vtkIdType(lines.size());
    if (this->LineType == Sticks)
    {
      std::vector<FaultSheet> sheets = MakeFaultSheets(lines, this->ExtendSticks);
      if (isFirst) // All horizons have the same fault surfaces.
      {
        WriteFaultSheets(sheets, outputs[2]);
      }
      ToLattice(sheets, points.Lattice);
      polylines = FindTraces(ColumnHeights(points.Column, points.Height), sheets);
    }
    else
    {
      polylines = ToMap(lines, points.Lattice);
      this->UsePolygons(polylines, points, outputs);
    }
  }
  const double indices =
    IndicesPerUnit(static_cast<HeightUnit>(this->ThrowUnit), points.Column, points.Height, points.Lattice);
  options.Noise *= indices;
  options.SmallestThrow = this->SmallestThrow > 0.0 ? this->SmallestThrow * indices
                                                    : ThrowAboveNoise(points.Column, points.Height, options.Noise);
  const ColumnHeights heights(points.Column, points.Height);
  monitor.Progress(0.2);
  FaultLines lines = CutAlong(heights, polylines);
  this->NumberOfGivenLines = givenLines;
  this->DoesGivenLineCut = this->DoesGivenLineCut || lines.Size() > 0;
  vtkNew<vtkFieldData> figures; // These include figures from ReadColumns.
  figures->ShallowCopy(output->GetFieldData());
  output->ShallowCopy(points.Horizon);
  output->SetFieldData(figures);
  if (this->Detect)
  {
    const FaultDetection detection = DetectFaults(heights, options, monitor.Step(0.2, 0.95));
    lines.Append(detection.Lines);
    this->MeasuredNoise = std::max(this->MeasuredNoise, detection.Noise);
    AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::FaultNoise, detection.Noise);
    AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::SmallestFaultThrow, detection.High);
  }
  WriteCuts(lines, output->GetFieldData());
  const double sum = std::accumulate(points.Height.begin(), points.Height.end(), 0.0);
  WriteFaultLines(lines, points.Lattice, sum / double(points.Height.size()), outputs[1]);
  this->NumberOfFaultLines += vtkIdType(lines.Size());
  this->NumberOfFaultedLinks += output->GetFieldData()->GetAbstractArray(FieldArray::FaultedLinks)->GetNumberOfTuples();
}
