// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceReport.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <limits>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, Directions> DirectionNames = { "Reference to mesh", "Mesh to reference",
  "Two-sided" };

// Field data tuples and table rows have this order of units.
constexpr std::size_t WorldUnit = 1;
constexpr std::size_t DiagonalUnit = 2;
constexpr std::array<const char*, 3> UnitNames = { "Lattice", "World", "Diagonal" };

constexpr const char* GradingMedian = "GradingMedian";
constexpr const char* Grading95 = "Grading95";
constexpr const char* Samples = "Samples";
constexpr const char* BinFrom = "bin_extents"; // ParaView's charts expect this name for their x axis.
constexpr const char* BinShare = "Area (%)";

using DistanceFigure = std::pair<std::string, double>;

std::vector<DistanceFigure> ListFigures(const DistanceFigures& figures)
{
  std::vector<DistanceFigure> list = { { FieldArray::LargestDistance, figures.Largest },
    { FieldArray::LargestDistanceFound, figures.LargestFound }, { FieldArray::MeanDistance, figures.Mean },
    { FieldArray::RmsDistance, figures.Rms } };
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    list.emplace_back(FieldArray::DistancePercentile + std::to_string(Percentiles[n]), figures.Percentile[n]);
  }
  list.emplace_back(FieldArray::OutlineDistance, figures.Outline);
  return list;
}

/// The diagonal is in lattice units.
std::vector<DistanceFigure> ListFigures(const DistanceReport& report, std::size_t direction, std::size_t unit)
{
  std::vector<DistanceFigure> list =
    ListFigures(unit == WorldUnit ? report.World[direction] : report.Lattice[direction]);
  for (DistanceFigure& figure : list)
  {
    figure.second = unit == DiagonalUnit ? figure.second / report.Diagonal : figure.second;
  }
  return list;
}

template <typename Array>
void AddColumn(const std::string& name, vtkTable* table)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  table->AddColumn(column);
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteFieldData(const DistanceReport& report, const Grading& grading, vtkPolyData* output)
{
  const std::vector<DistanceFigure> names = ListFigures(DistanceFigures());
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    auto array = NewArray<vtkDoubleArray>(names[n].first.c_str(), vtkIdType(Directions), int(UnitNames.size()));
    for (std::size_t unit = 0; unit < UnitNames.size(); ++unit)
    {
      array->SetComponentName(vtkIdType(unit), UnitNames[unit]);
      for (std::size_t direction = 0; direction < Directions; ++direction)
      {
        array->SetComponent(vtkIdType(direction), int(unit), ListFigures(report, direction, unit)[n].second);
      }
    }
    output->GetFieldData()->AddArray(array);
  }
  auto array = NewArray<vtkDoubleArray>(FieldArray::Grading, 1, 2);
  array->SetComponentName(0, "Median");
  array->SetComponentName(1, "Percentile95");
  array->SetTuple2(0, grading.Median, grading.Percentile95);
  output->GetFieldData()->AddArray(array);
}

//----------------------------------------------------------------------------------------------------------------------
void MakeColumns(vtkTable* table)
{
  for (const char* name : { "Horizon", "Direction", "Unit" })
  {
    AddColumn<vtkStringArray>(name, table);
  }
  for (const DistanceFigure& figure : ListFigures(DistanceFigures()))
  {
    AddColumn<vtkDoubleArray>(figure.first, table);
  }
  AddColumn<vtkDoubleArray>(GradingMedian, table);
  AddColumn<vtkDoubleArray>(Grading95, table);
  AddColumn<vtkIdTypeArray>(Samples, table);
}

//----------------------------------------------------------------------------------------------------------------------
void AppendRows(const DistanceReport& report, const std::string& horizon, vtkTable* table)
{
  const auto text = [table](const char* column)
  { return vtkStringArray::SafeDownCast(table->GetColumnByName(column)); };
  const auto number = [table](const std::string& column)
  { return vtkDoubleArray::SafeDownCast(table->GetColumnByName(column.c_str())); };
  for (std::size_t unit = 0; unit < UnitNames.size(); ++unit)
  {
    for (std::size_t direction = 0; direction < Directions; ++direction)
    {
      text("Horizon")->InsertNextValue(horizon);
      text("Direction")->InsertNextValue(DirectionNames[direction]);
      text("Unit")->InsertNextValue(UnitNames[unit]);
      for (const DistanceFigure& figure : ListFigures(report, direction, unit))
      {
        number(figure.first)->InsertNextValue(figure.second);
      }
      const bool ofOne = direction < report.Surfaces.size();
      number(GradingMedian)->InsertNextValue(ofOne ? report.Surfaces[direction].Median : NoValue);
      number(Grading95)->InsertNextValue(ofOne ? report.Surfaces[direction].Percentile95 : NoValue);
      vtkIdTypeArray::SafeDownCast(table->GetColumnByName(Samples))
        ->InsertNextValue(report.Lattice[direction].Samples); // All units have the same samples.
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MakeBinColumns(vtkTable* table)
{
  for (const char* name : { "Horizon", "Unit" })
  {
    AddColumn<vtkStringArray>(name, table);
  }
  for (const char* name : { BinFrom, BinShare })
  {
    AddColumn<vtkDoubleArray>(name, table);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void AppendBins(const DistanceReport& report, bool inWorldUnits, const std::string& horizon, vtkTable* table)
{
  const DistanceFigures& figures = (inWorldUnits ? report.World : report.Lattice).back();
  const double width = figures.Percentile.back() / double(DistanceBins - 1);
  for (std::size_t bin = 0; bin < DistanceBins; ++bin)
  {
    vtkStringArray::SafeDownCast(table->GetColumnByName("Horizon"))->InsertNextValue(horizon);
    vtkStringArray::SafeDownCast(table->GetColumnByName("Unit"))
      ->InsertNextValue(UnitNames[inWorldUnits ? WorldUnit : 0]);
    for (const auto& [column, value] :
      { std::pair(BinFrom, width * double(bin)), std::pair(BinShare, 100.0 * figures.Share[bin]) })
    {
      vtkDoubleArray::SafeDownCast(table->GetColumnByName(column))->InsertNextValue(value);
    }
  }
}
}
