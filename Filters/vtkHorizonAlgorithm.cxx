// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/RankedHorizons.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Common/StageReport.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
// ---- Results --------------------------------------------------------------------------------------------------------

// A panel has no room for more.
constexpr std::size_t MostLines = 50;
constexpr std::size_t MostInFull = 3;

class StageReport
{
public:
  void Add(const HorizonLeaf& leaf, const Horizon& input, const Horizon& output)
  {
    this->Entries.push_back(
      { leaf.Position, input.NumberOfPoints(), output.NumberOfPoints(), std::string(), std::string() });
    if (this->Entries.size() <= MostInFull)
    {
      this->Entries.back().Lines = ReportStage(leaf.Name, input, output);
    }
    if (this->Entries.size() <= MostLines)
    {
      this->Entries.back().Row = ReportRow(leaf.Name, input, output);
    }
  }

  /// Collects the entries of all ranks, sorted by position. Collective.
  void Join(const Ranks& ranks)
  {
    constexpr char separator = '\0'; // Names cannot contain it.
    std::ostringstream own = MakeReportStream();
    for (const Entry& entry : this->Entries)
    {
      own << entry.Position << ' ' << entry.PointsIn << ' ' << entry.PointsOut << ' ' << entry.Lines << separator
          << entry.Row << separator;
    }
    this->Entries.clear();
    for (const std::string& others : ranks.Gather(own.str()))
    {
      std::istringstream text(others);
      text.imbue(std::locale::classic());
      Entry entry{};
      while (text >> entry.Position >> entry.PointsIn >> entry.PointsOut && text.get() == ' ' &&
        std::getline(text, entry.Lines, separator) && std::getline(text, entry.Row, separator))
      {
        this->Entries.push_back(entry);
      }
    }
    std::stable_sort(this->Entries.begin(), this->Entries.end(),
      [](const Entry& a, const Entry& b) { return a.Position < b.Position; });
  }

  /// A line per figure, as panels are narrow: "2 horizons: 900 points in, 100 out", "Horizon 1: 300 points in, 40 out"
  /// and so on; a table if there are more horizons, of the first ones.
  std::string Text() const
  {
    std::ostringstream text = MakeReportStream();
    std::int64_t pointsIn = 0;
    std::int64_t pointsOut = 0;
    std::string lines;
    std::vector<std::string> rows;
    for (std::size_t n = 0; n < this->Entries.size(); ++n)
    {
      pointsIn += this->Entries[n].PointsIn;
      pointsOut += this->Entries[n].PointsOut;
      lines += n < MostInFull ? this->Entries[n].Lines : "";
      if (n < MostLines)
      {
        rows.push_back(this->Entries[n].Row);
      }
    }
    if (this->Entries.size() > 1)
    {
      text << this->Entries.size() << " horizons: " << pointsIn << " points in, " << pointsOut << " out\n";
    }
    text << (this->Entries.size() > MostInFull ? Tabulate(rows) : lines);
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
    std::string Lines; // Empty after the first horizons, as is the row.
    std::string Row;
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
void vtkHorizonAlgorithm::ProcessHorizon(const Horizon& input, Outputs& outputs, const Monitor& monitor)
{
  std::vector<vtkSmartPointer<vtkPolyData>> made;
  std::vector<vtkPolyData*> datasets;
  for (const Horizon& output : outputs)
  {
    made.push_back(ToVTK(output));
    datasets.push_back(made.back());
  }
  this->ProcessPolyData(ToVTK(input), datasets, monitor);
  std::transform(datasets.begin(), datasets.end(), outputs.begin(), [](vtkPolyData* data) { return FromVTK(data); });
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessPolyData(vtkPolyData*, const std::vector<vtkPolyData*>&, const Monitor&) {}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessOutputs(const std::vector<vtkDataObject*>&) {}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ShareHorizons(
  const std::vector<HorizonLeaf>&, const std::vector<RankedHorizon>&, const Ranks&)
{
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessOnRanks(
  const RankedHorizon& horizon, const Ranks& ranks, const Monitor&, const std::function<void()>& process)
{
  if (horizon.Rank == ranks.Own())
  {
    process();
  }
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::Warn(const std::string& text)
{
  vtkWarningMacro(<< this->HorizonName << (this->HorizonName.empty() ? "" : ": ") << text);
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::Warn(const std::vector<std::string>& texts)
{
  for (const std::string& text : texts)
  {
    this->Warn(text);
  }
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
vtkHorizonAlgorithm::Outputs vtkHorizonAlgorithm::Process(
  const Horizon& given, const HorizonLeaf& leaf, const Monitor& monitor)
{
  Outputs made(leaf.Outputs.size()); // They stay empty if the horizon is left out.
  RunPart(this, this->GetInvalidHorizons() == LeaveOut, leaf.Name, { leaf.Outputs.begin(), leaf.Outputs.end() },
    [&]()
    {
      Outputs outputs(made.size());
      const auto process = [&]()
      {
        this->ProcessHorizon(given, outputs, monitor);
        return std::vector<std::string>();
      };
      this->Warn(RunStage(given, this->TakesMeshes(), outputs, process));
      made = std::move(outputs);
    });
  for (std::size_t port = 0; port < made.size(); ++port)
  {
    ToVTK(made[port], leaf.Outputs[port]);
  }
  return made;
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
    const std::vector<RankedHorizon> all = ListOnRanks(horizons, ranks);
    this->ShareHorizons(horizons, all, ranks);
    ranks.Together(
      [&]()
      {
        const double size = double(horizons.size());
        std::vector<unsigned char> isDone(horizons.size(), 0);
        const auto process = [&](std::size_t n)
        {
          const HorizonLeaf& horizon = horizons[n];
          subject = this->HorizonName = horizon.Name;
          if (horizon.Input->GetNumberOfPoints() > 0 && isDone[n] == 0)
          {
            const Monitor step = monitor.Step(double(n) / size, double(n + 1) / size);
            const Horizon given = FromVTK(horizon.Input);
            const Outputs made = this->Process(given, horizon, step);
            report.Add(horizon, given, made.front());
          }
          isDone[n] = 1;
        };
        for (const RankedHorizon& one : all)
        {
          if (ranks.Size() > 1 && this->IsForAllRanks(one))
          {
            this->ProcessOnRanks(one, ranks, monitor, [&]() { process(one.Leaf); });
          }
        }
        for (std::size_t n = 0; n < horizons.size(); ++n)
        {
          process(n);
        }
        subject.clear();
        this->ProcessOutputs(outputs);
      });
    report.Join(ranks);
  };
  this->Results.clear();
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = IsAborted(this) ? StoppedReport : done ? report.Text() : std::string();
  this->Results = done && this->Results.empty() ? "no points in the input: nothing was made\n" : this->Results;
  return done;
}
