// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StageReport.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Ledger.h"
#include "Common/VTK/LedgerFields.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/SurveyFields.h"
#include "HeightUnit.h"
#include "HorizonData.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <locale>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// A panel has no room for more.
constexpr std::size_t MostLines = 50;

/// Reported in the unit of z as well.
constexpr const char* Heights = "vertical indices";

constexpr const char* WorldHeights = "in z";

struct Figure
{
  const char* Array;
  const char* Name;
  const char* Unit = "";
  bool IsToldAtZero = false;
};

/// Those that a reader looks for, in the order of the stages.
constexpr std::array<Figure, 42> Figures = { {
  { FieldArray::NumberOfSpikes, "spikes" },
  { FieldArray::SpikeThreshold, "threshold of spikes", Heights },
  { FieldArray::NumberOfSpurPoints, "points on spurs" },
  { FieldArray::FaultNoise, "noise", Heights },
  { FieldArray::SmallestFaultThrow, "smallest throw", Heights },
  { FieldArray::NumberOfFilledHoles, "holes filled" },
  { FieldArray::NumberOfOpenHoles, "holes left open" },
  { FieldArray::RimSmoothing, "rim smoothing", "", true },
  { FieldArray::RimWidth, "rim width", "columns" },
  { FieldArray::NumberOfPatches, "patches" },
  { FieldArray::NumberOfHoles, "holes with a loop" },
  { FieldArray::DroppedSmallPatchPoints, "points in small patches left out" },
  { FieldArray::IsochoreLeast, "least thickness", WorldHeights, true },
  { FieldArray::IsochoreMean, "mean thickness", WorldHeights, true },
  { FieldArray::IsochoreLargest, "largest thickness", WorldHeights, true },
  { FieldArray::IsochoreVolume, "volume", "cubic units" },
  { FieldArray::IsochoreCrossings, "columns where the horizons cross", "", true },
  { FieldArray::TriangleCount, "triangles" },
  { FieldArray::FaultTriangleCount, "triangles that close faults" },
  { FieldArray::NonDelaunayEdgeCount, "edges that are not Delaunay" },
  { FieldArray::SmallestAngle, "smallest angle", "degrees" },
  { FieldArray::SliverCount, "triangles with an angle below the one asked for" },
  { FieldArray::LargestError, "largest vertical error", Heights },
  { FieldArray::MeanError, "mean vertical error", Heights },
  { FieldArray::LargestLoopError, "largest vertical error of outlines", Heights },
  { FieldArray::NumberOfOutsidePoints, "points outside the outlines" },
  { FieldArray::OutlineDeviation, "outlines moved on the map by up to", "columns" },
  { FieldArray::OutlineHeightDeviation, "outlines off in height by up to", Heights },
  { FieldArray::BoundaryDeviation, "outlines off in space by up to", "lattice units" },
  { FieldArray::NumberOfParts, "parts" },
  { FieldArray::SeamPoints, "vertices on seams" },
  { FieldArray::ChosenRadius, "chosen radius", "columns" },
  { FieldArray::ChosenSmallestHoleSize, "smallest open hole", "columns" },
  { FieldArray::ChosenOutlineTolerance, "outline tolerance", "columns" },
  { FieldArray::ChosenDistanceThreshold, "distance threshold", "lattice units" },
  { FieldArray::ChosenMaximumError, "maximum error", Heights },
  { FieldArray::HeightNoise, "six times the noise of", Heights },
  { FieldArray::HeightRounding, "six times the rounding of", Heights },
  { FieldArray::ChosenMaximumNumberOfPoints, "most points" },
  { FieldArray::ChosenCellSize, "cell size", "columns" },
  { FieldArray::ChosenFlatnessThreshold, "flatness threshold" },
  { FieldArray::DroppedDuplicates, "points left out of columns with several" },
} };

std::ostringstream MakeStream()
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::setprecision(4);
  return stream;
}

/// Returns the unit, and a height in the unit of z as well.
std::string ReportUnit(const Figure& figure, double height, vtkPolyData* horizon)
{
  const std::string ownUnit = *figure.Unit ? std::string(" ") + figure.Unit : "";
  if (figure.Unit != Heights && figure.Unit != WorldHeights)
  {
    return ownUnit;
  }
  const std::string unit = ReadSurveyFields(horizon->GetFieldData()).VerticalUnit;
  if (figure.Unit == WorldHeights)
  {
    return unit.empty() ? ownUnit : " " + unit;
  }
  std::ostringstream text = MakeStream();
  text << ownUnit << ", " << height * WorldPerIndex(ReadLattice(horizon)) << (unit.empty() ? " in z" : " " + unit);
  return text.str();
}

std::string ReportCuts(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* const lines = output->GetFieldData()->GetArray(FieldArray::FaultLine);
  const bool isOfStage = lines && lines != input->GetFieldData()->GetArray(FieldArray::FaultLine);
  if (!isOfStage || lines->GetNumberOfTuples() == 0)
  {
    return {};
  }
  std::ostringstream text = MakeStream();
  text << "\n  fault lines " << vtkIdType(lines->GetRange(0)[1]) + 1 << "\n  links cut " << lines->GetNumberOfTuples();
  return text.str();
}

/// Entries that are a large fraction of the columns are a warning.
std::string ReportLedger(vtkPolyData* input, vtkPolyData* output)
{
  vtkFieldData* const figures = output->GetFieldData();
  const auto ledger = ReadLedger(figures);
  const char* const name = FieldArray::LedgerColumns;
  if (!ledger || figures->GetArray(name) == input->GetFieldData()->GetArray(name))
  {
    return {};
  }
  vtkDataArray* const areas = figures->GetArray(FieldArray::LedgerArea);
  std::ostringstream text = MakeStream();
  for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
  {
    if (ledger->Columns[entry] > 0)
    {
      text << "\n  columns " << LedgerWords[entry] << ' ' << ledger->Columns[entry];
      text << (areas ? ", area " : "");
      if (areas)
      {
        text << areas->GetComponent(0, int(entry));
      }
    }
  }
  const char* before = "\n  warning: ";
  for (const LedgerWarning& warning : FindWarnings(*ledger))
  {
    text << before << warning.Text;
    before = ", ";
  }
  return text.str();
}

/// Null unless this stage has written the figure, and it is worth reporting.
vtkDataArray* FindFigure(const Figure& figure, vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* const array = output->GetFieldData()->GetArray(figure.Array);
  const bool isOfStage = array && array != input->GetFieldData()->GetArray(figure.Array);
  const bool isTold =
    isOfStage && array->GetNumberOfValues() == 1 && (figure.IsToldAtZero || array->GetTuple1(0) != 0.0);
  return isTold ? array : nullptr;
}
}

//----------------------------------------------------------------------------------------------------------------------
void StageReport::Add(int position, const std::string& name, vtkPolyData* input, vtkPolyData* output)
{
  this->Entries.push_back({ position, input->GetNumberOfPoints(), output->GetNumberOfPoints(), std::string() });
  if (this->Entries.size() > MostLines)
  {
    return;
  }
  std::ostringstream line = MakeStream();
  line << (name.empty() ? "" : name + ": ") << input->GetNumberOfPoints() << " points in, "
       << output->GetNumberOfPoints() << " out";
  line << ReportCuts(input, output);
  for (const Figure& figure : Figures)
  {
    if (vtkDataArray* const array = FindFigure(figure, input, output))
    {
      line << "\n  " << figure.Name << ' ';
      if (array->GetDataType() == VTK_DOUBLE)
      {
        line << array->GetTuple1(0);
      }
      else
      {
        line << vtkIdType(array->GetTuple1(0)); // Counts have all digits.
      }
      line << ReportUnit(figure, array->GetTuple1(0), output);
    }
  }
  line << ReportLedger(input, output);
  this->Entries.back().Lines = line.str() + "\n";
}

//----------------------------------------------------------------------------------------------------------------------
void StageReport::Join(const Ranks& ranks)
{
  constexpr char separator = '\0'; // Names cannot contain it.
  std::ostringstream own = MakeStream();
  for (const Entry& entry : this->Entries)
  {
    own << entry.Position << ' ' << entry.PointsIn << ' ' << entry.PointsOut << ' ' << entry.Lines << separator;
  }
  this->Entries.clear();
  for (const std::string& others : ranks.Gather(own.str()))
  {
    std::istringstream text(others);
    text.imbue(std::locale::classic());
    Entry entry{};
    while (text >> entry.Position >> entry.PointsIn >> entry.PointsOut && text.get() == ' ' &&
      std::getline(text, entry.Lines, separator))
    {
      this->Entries.push_back(entry);
    }
  }
  std::stable_sort(
    this->Entries.begin(), this->Entries.end(), [](const Entry& a, const Entry& b) { return a.Position < b.Position; });
}

//----------------------------------------------------------------------------------------------------------------------
std::string StageReport::Text() const
{
  std::ostringstream text = MakeStream();
  std::int64_t pointsIn = 0;
  std::int64_t pointsOut = 0;
  std::string lines;
  for (std::size_t n = 0; n < this->Entries.size(); ++n)
  {
    pointsIn += this->Entries[n].PointsIn;
    pointsOut += this->Entries[n].PointsOut;
    lines += n < MostLines ? this->Entries[n].Lines : "";
  }
  if (this->Entries.size() > 1)
  {
    text << this->Entries.size() << " horizons: " << pointsIn << " points in, " << pointsOut << " out\n";
  }
  text << lines;
  if (this->Entries.size() > MostLines)
  {
    text << "and " << this->Entries.size() - MostLines << " more\n";
  }
  return text.str();
}
}
