// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultPolyData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace SeismicHorizons
{
namespace
{
std::string WithoutLastWord(const std::string& text)
{
  const std::size_t blank = text.find_last_of(' ');
  return blank == std::string::npos ? text : text.substr(0, blank);
}

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
      std::array<double, 3> place{};
      data->GetPoint(points[n], place.data());
      polyline.Places.push_back({ place[0], place[1], place[2] });
    }
    if (arePolygons && !polyline.Places.empty())
    {
      polyline.Places.push_back(polyline.Places.front());
    }
    if (names)
    {
      polyline.Fault = WithoutLastWord(names->GetValue(first + cell));
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

class PolylineWriter
{
public:
  PolylineWriter(const Lattice& lattice, double height)
    : Lattice(lattice)
    , Height(height)
  {
    this->Points->SetDataTypeToDouble();
    this->Throws->SetName(PointArray::Throw);
    this->Numbers->SetName(CellArray::FaultLine);
  }

  void Append(const FaultLines& lines, std::size_t line)
  {
    const std::size_t start = lines.Start(line);
    const std::size_t end = lines.End(line);
    this->FindHeights(lines, start, end);
    this->Cells->InsertNextCell(int(end - start + 2));
    this->AppendPoint(EndOf(lines[start], false), this->Heights.front(), lines[start].LeftThrow());
    for (std::size_t n = start; n < end; ++n)
    {
      const PlanePoint before = lines[n].Place.Column;
      const PlanePoint beyond = lines[n].Place.Beyond();
      this->AppendPoint(
        { 0.5 * (before.X + beyond.X), 0.5 * (before.Y + beyond.Y) }, this->Heights[n - start], lines[n].LeftThrow());
    }
    this->AppendPoint(EndOf(lines[end - 1], true), this->Heights.back(), lines[end - 1].LeftThrow());
    this->Numbers->InsertNextValue(int(line));
  }

  void Finish(vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Cells);
    output->GetPointData()->AddArray(this->Throws);
    output->GetPointData()->SetActiveScalars(PointArray::Throw);
    output->GetCellData()->AddArray(this->Numbers);
  }

private:
  static MapPlace EndOf(const FaultedLink& cut, bool isLast)
  {
    const double shift = cut.IsForward == isLast ? 0.5 : -0.5;
    const PlanePoint column = cut.Place.Column;
    return cut.Place.Side == LinkSide::East ? MapPlace{ column.X + 0.5, column.Y + shift }
                                            : MapPlace{ column.X + shift, column.Y + 0.5 };
  }

  /// A link without a height takes the previous one, or else the first known one. Heights from one side only, as at a
  /// hole, count only if no link of the line has both.
  void FindHeights(const FaultLines& lines, std::size_t start, std::size_t end)
  {
    bool hasBoth = false;
    for (std::size_t n = start; n < end; ++n)
    {
      hasBoth = hasBoth || !std::isnan(lines[n].Throw);
    }
    const auto isKnown = [&lines, hasBoth](std::size_t n)
    { return !std::isnan(hasBoth ? lines[n].Throw : lines[n].Middle); };
    double last = this->Height;
    for (std::size_t n = end; n-- > start;)
    {
      last = isKnown(n) ? lines[n].Middle : last;
    }
    this->Heights.clear();
    for (std::size_t n = start; n < end; ++n)
    {
      last = isKnown(n) ? lines[n].Middle : last;
      this->Heights.push_back(last);
    }
  }

  void AppendPoint(const MapPlace& place, double height, double leftThrow)
  {
    const Eigen::Vector3d world = this->Lattice.ToWorld(Eigen::Vector3d(place.X, place.Y, height));
    this->Cells->InsertCellPoint(this->Points->InsertNextPoint(world.data()));
    this->Throws->InsertNextValue(leftThrow);
  }

  const SeismicHorizons::Lattice& Lattice;
  const double Height;
  std::vector<double> Heights;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkDoubleArray> Throws;
  vtkNew<vtkIntArray> Numbers;
};
}

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
void ToLattice(std::vector<FaultSheet>& sheets, const Lattice& lattice)
{
  for (FaultSheet& sheet : sheets)
  {
    for (std::size_t n = 0; n < sheet.NumberOfSticks() * sheet.NumberOfLevels(); ++n)
    {
      const Eigen::Vector3d place = lattice.ToLattice(Eigen::Vector3d(sheet[n].X, sheet[n].Y, sheet[n].Z));
      sheet[n] = { place.x(), place.y(), place.z() };
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFaultSheets(const std::vector<FaultSheet>& sheets, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkStringArray> names;
  names->SetName(CellArray::FaultName);
  for (const FaultSheet& sheet : sheets)
  {
    std::vector<vtkIdType> ids(sheet.NumberOfSticks() * sheet.NumberOfLevels(), -1);
    for (const std::array<std::size_t, 3>& triangle : sheet.ListTriangles())
    {
      triangles->InsertNextCell(3);
      for (const std::size_t place : triangle)
      {
        if (ids[place] < 0)
        {
          ids[place] = points->InsertNextPoint(sheet[place].X, sheet[place].Y, sheet[place].Z);
        }
        triangles->InsertCellPoint(ids[place]);
      }
      names->InsertNextValue(sheet.Name());
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetCellData()->AddArray(names);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFaultLines(const FaultLines& lines, const Lattice& lattice, double height, vtkPolyData* output)
{
  PolylineWriter writer(lattice, height);
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    writer.Append(lines, line);
  }
  writer.Finish(output);
}
}
