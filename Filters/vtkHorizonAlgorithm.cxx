// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Ledger.h"
#include "Common/VTK/LedgerFields.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/SurveyFields.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "Filters/Marshalling/LedgerOutput.h"
#include "Filters/Marshalling/PlacedPoints.h"
#include "Filters/Marshalling/RankedHorizons.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
// ---- Results --------------------------------------------------------------------------------------------------------

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

/// Null unless the stage has written the array.
vtkDataArray* FindOwnFigure(const char* name, vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* const array = output->GetFieldData()->GetArray(name);
  return array != input->GetFieldData()->GetArray(name) ? array : nullptr;
}

std::string ReportCuts(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* const lines = FindOwnFigure(FieldArray::FaultLine, input, output);
  if (!lines || lines->GetNumberOfTuples() == 0)
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
  const std::optional<Ledger> ledger = ReadLedger(figures);
  if (!ledger || !FindOwnFigure(FieldArray::LedgerColumns, input, output))
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

class StageReport
{
public:
  void Add(const HorizonLeaf& horizon)
  {
    vtkPolyData* const input = horizon.Input;
    vtkPolyData* const output = horizon.Outputs.front();
    this->Entries.push_back(
      { horizon.Position, input->GetNumberOfPoints(), output->GetNumberOfPoints(), std::string() });
    if (this->Entries.size() > MostLines)
    {
      return;
    }
    std::ostringstream line = MakeStream();
    line << (horizon.Name.empty() ? "" : horizon.Name + ": ") << input->GetNumberOfPoints() << " points in, "
         << output->GetNumberOfPoints() << " out" << ReportCuts(input, output);
    for (const Figure& figure : Figures)
    {
      vtkDataArray* const array = FindOwnFigure(figure.Array, input, output);
      if (array && array->GetNumberOfValues() == 1 && (figure.IsToldAtZero || array->GetTuple1(0) != 0.0))
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
    line << ReportLedger(input, output) << '\n';
    this->Entries.back().Lines = line.str();
  }

  /// Collects the entries of all ranks, sorted by position. Collective.
  void Join(const Ranks& ranks)
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
    std::stable_sort(this->Entries.begin(), this->Entries.end(),
      [](const Entry& a, const Entry& b) { return a.Position < b.Position; });
  }

  /// One line per horizon, and per figure as panels are narrow: "3 horizons: 900 points in, 100 out", "Horizon 1: 300
  /// points in, 40 out" and so on. Only the first horizons are listed.
  std::string Text() const
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

private:
  struct Entry
  {
    int Position; // HorizonLeaf::Position
    std::int64_t PointsIn;
    std::int64_t PointsOut;
    std::string Lines; // empty after the first horizons
  };
  std::vector<Entry> Entries;
};
}

// ---- The class ------------------------------------------------------------------------------------------------------

//------------------------------------------------------------------------------
vtkPolyData* vtkHorizonAlgorithm::GetPolyDataOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessOutputs(const std::vector<vtkDataObject*>&) {}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ShareHorizons(
  const std::vector<HorizonLeaf>&, const std::vector<RankedHorizon>&, const Ranks&)
{
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::Warn(const std::string& text)
{
  vtkWarningMacro(<< this->HorizonName << (this->HorizonName.empty() ? "" : ": ") << text);
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
  {
    AskForWhole(inputVector[port]);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfHorizonPorts(); ++port)
  {
    MakeOutputLike(vtkDataObject::GetData(inputVector[0], 0), outputVector->GetInformationObject(port));
  }
  return 1;
}

//------------------------------------------------------------------------------
// vtkCompositeDataPipeline would loop over leaves, but it continues after errors and aborts, keeps partial output, and
// does not join the partitions of a horizon.
int vtkHorizonAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  StageReport report;
  const auto work = [this, input, &outputs, &ranks, &report](std::string& subject, const Monitor& monitor)
  {
    std::vector<HorizonLeaf> horizons;
    const auto end = outputs.begin() + this->GetNumberOfHorizonPorts();
    ranks.Together([&]() { horizons = ListHorizons(input, { outputs.begin(), end }); });
    // This throws if several ranks have points of a horizon.
    this->ShareHorizons(horizons, ListOnRanks(horizons, ranks), ranks);
    ranks.Together(
      [&]()
      {
        const double size = double(horizons.size());
        for (std::size_t n = 0; n < horizons.size(); ++n)
        {
          const HorizonLeaf& horizon = horizons[n];
          subject = this->HorizonName = horizon.Name;
          if (horizon.Input->GetNumberOfPoints() > 0)
          {
            const Monitor step = monitor.Step(double(n) / size, double(n + 1) / size);
            RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject,
              { horizon.Outputs.begin(), horizon.Outputs.end() },
              [&]()
              {
                CheckArraySizes(horizon.Input);
                if (IsMesh(horizon.Input) && !this->TakesMeshes())
                {
                  throw InputError("a mesh of " +
                    std::to_string(horizon.Input->GetNumberOfPolys() + horizon.Input->GetNumberOfStrips()) +
                    " triangles, expected the points of a horizon, as they are before it is meshed");
                }
                if (CountVisiblePoints(horizon.Input) == 0)
                {
                  this->Warn("all " + std::to_string(horizon.Input->GetNumberOfPoints()) +
                    " points are hidden by the array vtkGhostType, so that nothing is left");
                  return;
                }
                this->ProcessHorizon(horizon.Input, horizon.Outputs, step);
                WriteLedgerOfPoints(horizon.Input, horizon.Outputs.front());
              });
            report.Add(horizon);
          }
        }
        subject.clear();
        this->ProcessOutputs(outputs);
      });
    report.Join(ranks);
  };
  this->Results.clear();
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = IsAborted(this) ? "stopped before the end: nothing was made\n" : done ? report.Text() : std::string();
  this->Results = done && this->Results.empty() ? "no points in the input: nothing was made\n" : this->Results;
  return done;
}
