// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StageReport.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "Common/Survey/SurveyFields.h"
#include "HeightUnit.h"
#include "HorizonData.h"
#include "HorizonPoints.h"
#include "LedgerOutput.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <optional>

namespace SeismicHorizons
{
namespace
{
/// Reported in the unit of z as well.
constexpr const char* LatticeHeights = "vertical indices";

constexpr const char* WorldHeights = "in z";

struct Figure
{
  const char* Array;
  const char* Name; ///< Empty if it is in tables only.
  const char* Unit = "";
  bool IsToldAtZero = false;
  const char* Head = ""; ///< Of its column in tables; empty if it is in none.
};

/// Those that a reader looks for, in the order of the stages.
constexpr std::array<Figure, 45> Figures = { {
  { FieldArray::FaultLine, "", "", false, "faults" },
  { FieldArray::NumberOfSpikes, "spikes", "", false, "spikes" },
  { FieldArray::SpikeThreshold, "threshold of spikes", LatticeHeights },
  { FieldArray::NumberOfSpurPoints, "points on spurs" },
  { FieldArray::FaultNoise, "noise", LatticeHeights },
  { FieldArray::SmallestFaultThrow, "smallest throw", LatticeHeights },
  { FieldArray::NumberOfFilledHoles, "holes filled" },
  { FieldArray::NumberOfFilledPoints, "", "", false, "filled" },
  { FieldArray::NumberOfOpenHoles, "holes left open", "", false, "open" },
  { FieldArray::RimSmoothing, "rim smoothing", "", true },
  { FieldArray::RimWidth, "rim width", "columns" },
  { FieldArray::NumberOfPatches, "patches", "", false, "patches" },
  { FieldArray::NumberOfHoles, "holes with a loop", "", false, "holes" },
  { FieldArray::DroppedSmallPatchPoints, "points in small patches left out", "", false, "dropped" },
  { FieldArray::IsochoreLeast, "least thickness", WorldHeights, true },
  { FieldArray::IsochoreMean, "mean thickness", WorldHeights, true, "mean" },
  { FieldArray::IsochoreLargest, "largest thickness", WorldHeights, true },
  { FieldArray::IsochoreVolume, "volume", "cubic units" },
  { FieldArray::IsochoreCrossings, "columns where the horizons cross", "", true, "crossing" },
  { FieldArray::NumberOfContours, "contours", "", true, "contours" },
  { FieldArray::ContourInterval, "interval", WorldHeights, false, "interval" },
  { FieldArray::TriangleCount, "triangles", "", false, "triangles" },
  { FieldArray::FaultTriangleCount, "triangles that close faults" },
  { FieldArray::NonDelaunayEdgeCount, "edges that are not Delaunay" },
  { FieldArray::SmallestAngle, "smallest angle", "degrees" },
  { FieldArray::SliverCount, "triangles with an angle below the one asked for", "", false, "slivers" },
  { FieldArray::LargestError, "largest vertical error", LatticeHeights, false, "error" },
  { FieldArray::MeanError, "mean vertical error", LatticeHeights },
  { FieldArray::LargestEdgeError, "largest vertical error of edges inside", LatticeHeights },
  { FieldArray::LargestLoopError, "largest vertical error of outlines", LatticeHeights, false, "outline" },
  { FieldArray::NumberOfOutsidePoints, "points outside the outlines", "", false, "outside" },
  { FieldArray::OutlineDeviation, "outlines moved on the map by up to", "columns" },
  { FieldArray::OutlineHeightDeviation, "outlines off in height by up to", LatticeHeights },
  { FieldArray::BoundaryDeviation, "outlines off in space by up to", "lattice units" },
  { FieldArray::ChosenRadius, "chosen radius", "columns" },
  { FieldArray::ChosenSmallestHoleSize, "smallest open hole", "columns" },
  { FieldArray::ChosenOutlineTolerance, "outline tolerance", "columns" },
  { FieldArray::ChosenDistanceThreshold, "distance threshold", "lattice units" },
  { FieldArray::ChosenMaximumError, "maximum error", LatticeHeights },
  { FieldArray::HeightNoise, "six times the noise of", LatticeHeights },
  { FieldArray::HeightRounding, "six times the rounding of", LatticeHeights },
  { FieldArray::ChosenMaximumNumberOfPoints, "most points" },
  { FieldArray::ChosenCellSize, "cell size", "columns" },
  { FieldArray::ChosenFlatnessThreshold, "flatness threshold" },
  { FieldArray::DroppedDuplicates, "points left out of columns with several", "", false, "duplicates" },
} };

/// Returns the unit, and a height in the unit of z as well.
std::string ReportUnit(const Figure& figure, double height, const Horizon& horizon)
{
  const std::string ownUnit = *figure.Unit ? std::string(" ") + figure.Unit : "";
  if (figure.Unit != LatticeHeights && figure.Unit != WorldHeights)
  {
    return ownUnit;
  }
  const std::string unit = ReadSurveyFields(horizon.FieldData).VerticalUnit;
  if (figure.Unit == WorldHeights)
  {
    return unit.empty() ? ownUnit : " " + unit;
  }
  std::ostringstream text = MakeReportStream();
  text << ownUnit << ", " << height * WorldPerIndex(ReadLattice(horizon)) << (unit.empty() ? " in z" : " " + unit);
  return text.str();
}

/// Null unless the stage has written the array.
const DataArray* FindOwnFigure(const char* name, const Horizon& input, const Horizon& output)
{
  const DataArray* const array = output.FieldData.Find(name);
  const DataArray* const given = input.FieldData.Find(name);
  return array && !(given && array->IsCopyOf(*given)) ? array : nullptr;
}

int CountFaultLines(const DataArray& lines)
{
  const int* const numbers = lines.As<int>();
  return lines.Tuples() > 0 ? *std::max_element(numbers, numbers + lines.Tuples()) + 1 : 0;
}

std::string ReportCuts(const Horizon& input, const Horizon& output)
{
  const DataArray* const lines = FindOwnFigure(FieldArray::FaultLine, input, output);
  if (!lines || lines->Tuples() == 0)
  {
    return {};
  }
  std::ostringstream text = MakeReportStream();
  text << "\n  fault lines " << CountFaultLines(*lines) << "\n  links cut " << lines->Tuples();
  return text.str();
}

std::string ReportWarnings(const Ledger& ledger)
{
  std::string text;
  for (const LedgerWarning& warning : FindWarnings(ledger))
  {
    text += (text.empty() ? "" : ", ") + warning.Text;
  }
  return text;
}

/// Entries that are a large fraction of the columns are a warning.
std::string ReportLedger(const Horizon& input, const Horizon& output)
{
  const std::optional<Ledger> ledger = ReadLedger(output.FieldData);
  if (!ledger || !FindOwnFigure(FieldArray::LedgerColumns, input, output))
  {
    return {};
  }
  const DataArray* const areas = output.FieldData.Find(FieldArray::LedgerArea);
  std::ostringstream text = MakeReportStream();
  for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
  {
    if (ledger->Columns[entry] > 0)
    {
      text << "\n  columns " << LedgerWords[entry] << ' ' << ledger->Columns[entry];
      text << (areas ? ", area " : "");
      if (areas)
      {
        text << areas->Value(std::int64_t(entry));
      }
    }
  }
  const std::string warnings = ReportWarnings(*ledger);
  text << (warnings.empty() ? "" : "\n  warning: ") << warnings;
  return text.str();
}

std::vector<const Figure*> ListColumns()
{
  std::vector<const Figure*> columns;
  for (const Figure& figure : Figures)
  {
    if (*figure.Head)
    {
      columns.push_back(&figure);
    }
  }
  return columns;
}

std::vector<std::string> SplitCells(const std::string& row)
{
  std::vector<std::string> cells;
  std::istringstream text(row);
  for (std::string cell; std::getline(text, cell, '\t');)
  {
    cells.push_back(cell);
  }
  return cells;
}

std::size_t CountCharacters(const std::string& text) // in UTF-8
{
  return std::size_t(std::count_if(
    text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

/// Names, in the first column, are flush left, and figures flush right.
void AlignColumn(const std::vector<std::string>& cells, std::vector<std::string>& lines)
{
  std::size_t width = 0;
  for (const std::string& cell : cells)
  {
    width = std::max(width, CountCharacters(cell));
  }
  const bool isFirst = lines.front().empty();
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const std::string blanks(width - CountCharacters(cells[n]), ' ');
    lines[n] += isFirst ? cells[n] + blanks : " " + blanks + cells[n];
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> RunStage(const Horizon& input, bool takesMeshes, std::vector<Horizon>& outputs,
  const std::function<std::vector<std::string>()>& stage)
{
  CheckArraySizes(input);
  if (input.IsMesh() && !takesMeshes)
  {
    throw InputError("a mesh of " + std::to_string(input.Polygons.Size() + input.Strips) +
      " triangles, expected the points of a horizon, as they are before it is meshed");
  }
  for (Horizon& output : outputs)
  {
    output.FieldData = WithoutMeshFigures(input.FieldData);
  }
  if (CountVisiblePoints(input) == 0)
  {
    return { "all " + std::to_string(input.NumberOfPoints()) +
      " points are hidden by the array vtkGhostType, so that nothing is left" };
  }
  std::vector<std::string> warnings = stage();
  WriteLedgerOfPoints(input, outputs.front());
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
std::ostringstream MakeReportStream()
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::setprecision(4);
  return stream;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ReportStage(const std::string& name, const Horizon& input, const Horizon& output)
{
  std::ostringstream line = MakeReportStream();
  line << (name.empty() ? "" : name + ": ") << input.NumberOfPoints() << " points in, " << output.NumberOfPoints()
       << " out" << ReportCuts(input, output);
  for (const Figure& figure : Figures)
  {
    const DataArray* const array = FindOwnFigure(figure.Array, input, output);
    if (*figure.Name && array && array->Size() == 1 && (figure.IsToldAtZero || array->At(0) != 0.0))
    {
      line << "\n  " << figure.Name << ' ';
      if (array->Type() == ValueType::Double)
      {
        line << array->At(0);
      }
      else
      {
        line << std::int64_t(array->At(0)); // Counts have all digits.
      }
      line << ReportUnit(figure, array->At(0), output);
    }
  }
  line << ReportLedger(input, output) << '\n';
  return line.str();
}

//----------------------------------------------------------------------------------------------------------------------
std::string ReportRow(const std::string& name, const Horizon& input, const Horizon& output)
{
  std::ostringstream row = MakeReportStream();
  std::string first = name;
  std::replace(first.begin(), first.end(), '\t', ' ');
  row << first << '\t' << input.NumberOfPoints() << '\t' << output.NumberOfPoints();
  for (const Figure* const figure : ListColumns())
  {
    const DataArray* const array = FindOwnFigure(figure->Array, input, output);
    row << '\t';
    if (array && figure->Array == FieldArray::FaultLine)
    {
      row << CountFaultLines(*array);
    }
    else if (array && array->Size() == 1 && array->Type() == ValueType::Double)
    {
      row << array->At(0) * (figure->Unit == LatticeHeights ? WorldPerIndex(ReadLattice(output)) : 1.0);
    }
    else if (array && array->Size() == 1)
    {
      row << std::int64_t(array->At(0));
    }
  }
  const std::optional<Ledger> ledger = ReadLedger(output.FieldData);
  const bool isOwn = ledger && FindOwnFigure(FieldArray::LedgerColumns, input, output);
  row << '\t' << ReadSurveyFields(output.FieldData).VerticalUnit << '\t' << (isOwn ? ReportWarnings(*ledger) : "");
  return row.str();
}

//----------------------------------------------------------------------------------------------------------------------
std::string Tabulate(const std::vector<std::string>& rows)
{
  const std::vector<const Figure*> columns = ListColumns();
  constexpr std::size_t before = 3; // The figures start after so many columns.
  const std::size_t unit = columns.size() + before;
  std::vector<std::vector<std::string>> cells;
  for (const std::string& row : rows)
  {
    cells.push_back(SplitCells(row));
    cells.back().resize(unit + 2); // name, points in and out, figures, unit of z, warnings
  }
  const bool isOneUnit = std::all_of(cells.begin(), cells.end(),
    [&](const std::vector<std::string>& row) { return !row[unit].empty() && row[unit] == cells.front()[unit]; });
  std::vector<std::string> lines(rows.size() + 1);
  for (std::size_t column = 0; column < unit; ++column)
  {
    const Figure* const figure = column < before ? nullptr : columns[column - before];
    std::vector<std::string> entries = { column == 0 ? "horizon"
        : column == 1                                ? "in"
        : column == 2                                ? "points"
                                                     : figure->Head };
    if (figure && (figure->Unit == LatticeHeights || figure->Unit == WorldHeights))
    {
      entries.front() += " (" + (isOneUnit ? cells.front()[unit] : "z") + ")";
    }
    bool isNeeded = column == 0 || column == 2;
    for (const std::vector<std::string>& row : cells)
    {
      isNeeded = isNeeded || (figure ? !row[column].empty() && row[column] != "0" : row[1] != row[2]);
      entries.push_back(row[column]);
    }
    if (isNeeded)
    {
      AlignColumn(entries, lines);
    }
  }
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + "\n";
  }
  for (const std::vector<std::string>& row : cells)
  {
    text += row[unit + 1].empty() ? "" : row[0] + ": " + row[unit + 1] + "\n";
  }
  return text;
}
}
