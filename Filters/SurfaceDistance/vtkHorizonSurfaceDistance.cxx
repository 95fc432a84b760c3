// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurfaceDistance.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/RankedHorizons.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "DistanceStage.h"
#include "Filters/Common/StageReport.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

struct SeismicHorizons::HorizonPair
{
  std::string Name; // empty if unnamed
  vtkSmartPointer<vtkPolyData> Reference;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> ReferenceOutput;
  vtkSmartPointer<vtkPolyData> MeshOutput;
  std::array<vtkSmartPointer<vtkTable>, 2> Rows; // rows of the pair for each table
};

namespace
{
using namespace SeismicHorizons;

constexpr int ReferencePort = 0;
constexpr int MeasuredPort = 1;
constexpr int FiguresPort = 2;
constexpr int HistogramPort = 3;

// ---- Pairs ----------------------------------------------------------------------------------------------------------

std::string ListUnpaired(const std::vector<RankedHorizon>& horizons)
{
  std::string text;
  for (const RankedHorizon& horizon : horizons)
  {
    text += (text.empty() ? "" : ", ") + (horizon.Name.empty() ? "one without a name" : horizon.Name);
  }
  return text.empty() ? "no horizon" : text;
}

std::string NoPartner(
  const char* missing, const RankedHorizon& horizon, const char* side, const std::vector<RankedHorizon>& others)
{
  return std::string("no ") + missing + " for " + (horizon.Name.empty() ? "a horizon without a name" : horizon.Name) +
    " of the " + side + ", expected one of that name; there is " + ListUnpaired(others);
}

void AppendPairRows(vtkTable* rows, vtkTable* table)
{
  for (vtkIdType row = 0; row < rows->GetNumberOfRows(); ++row)
  {
    table->InsertNextRow(rows->GetRow(row));
  }
}

std::vector<vtkDataObject*> ListInputs(vtkInformationVector** inputVector)
{
  std::vector<vtkDataObject*> inputs;
  for (const int port : { ReferencePort, MeasuredPort })
  {
    for (int n = 0; n < inputVector[port]->GetNumberOfInformationObjects(); ++n)
    {
      inputs.push_back(vtkDataObject::GetData(inputVector[port], n));
    }
  }
  return inputs;
}

/// Collective. Outputs are made before triangles are known, like the inputs in their order.
void PutMeshLast(std::vector<vtkDataObject*>& inputs, const std::vector<vtkDataObject*>& outputs, const Ranks& ranks)
{
  if (inputs.size() != 2)
  {
    ranks.Refuse(std::to_string(inputs.size()) + (inputs.size() == 1 ? " input" : " inputs") +
      ", expected two: a horizon and the mesh that represents it");
  }
  const auto hasTriangles = [&ranks](vtkDataObject* input)
  {
    bool isAny = false;
    ranks.Together(
      [&]()
      {
        const std::vector<HorizonLeaf> leaves = ListHorizons(input, {});
        isAny = std::any_of(leaves.begin(), leaves.end(),
          [](const HorizonLeaf& leaf) { return leaf.Input->GetNumberOfPolys() + leaf.Input->GetNumberOfStrips() > 0; });
      });
    return ranks.Any(isAny);
  };
  if (hasTriangles(inputs[0]) && !hasTriangles(inputs[1]))
  {
    if (outputs[ReferencePort]->GetDataObjectType() != outputs[MeasuredPort]->GetDataObjectType())
    {
      ranks.Refuse("the mesh as the reference, and points as the mesh, expected them the other way round");
    }
    std::swap(inputs[0], inputs[1]);
  }
}

/// Tells the figures of both directions.
std::string TellFigures(vtkTable* figures, const std::string& unit)
{
  const std::vector<std::pair<const char*, std::string>> told = { { "largest distance ", FieldArray::LargestDistance },
    { "mean distance ", FieldArray::MeanDistance }, { "root mean square ", FieldArray::RmsDistance },
    { "95 % of the area within ", FieldArray::DistancePercentile + std::string("95") },
    { "outlines apart on the map by at most ", FieldArray::OutlineDistance } };
  std::ostringstream text = MakeReportStream();
  for (vtkIdType row = 0; row < figures->GetNumberOfRows(); ++row)
  {
    const auto value = [&](const std::string& column) { return figures->GetValueByName(row, column.c_str()); };
    if (value("Direction").ToString() != DirectionNames.back() || value("Unit").ToString() != unit)
    {
      continue;
    }
    const std::string name = value("Horizon").ToString();
    text << (name.empty() ? "the horizon" : name) << ", in "
         << (unit == "World" ? "units of the coordinates" : "columns and vertical indices") << ":\n";
    for (const auto& [words, column] : told)
    {
      const double figure = value(column).ToDouble();
      if (!std::isnan(figure))
      {
        text << "  " << words << figure << '\n';
      }
    }
  }
  return text.str();
}

/// A single horizon on either side makes a pair with any names. Otherwise names must agree, and equal names pair in
/// order. The rank of the reference works on a pair: it receives the mesh, and Deliver returns the output.
class HorizonPairs
{
public:
  /// Throws InputError if a horizon has no counterpart, and on other data than vtkPolyData. Collective. Refers to
  /// `ranks`.
  HorizonPairs(vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput,
    const Ranks& ranks)
    : Group(ranks)
  {
    std::vector<HorizonLeaf> references;
    std::vector<HorizonLeaf> meshes;
    ranks.Together(
      [&]()
      {
        references = ListHorizons(reference, { referenceOutput });
        meshes = ListHorizons(mesh, { meshOutput });
        for (std::size_t n = 0; ranks.Size() > 1 && n < meshes.size(); ++n) // Sending makes VTK read their arrays.
        {
          PrefixErrors(meshes[n].Name, [&]() { CheckArraySizes(meshes[n].Input); });
        }
      });
    this->MatchNames(ListOnRanks(references, ranks), ListOnRanks(meshes, ranks));
    for (const Match& match : this->Matches)
    {
      this->Take(match, references, meshes);
    }
  }

  const std::vector<HorizonPair>& OwnPairs() const { return this->Own; }

  /// Sends outputs to the ranks of the meshes, and all rows, in the order of pairs, to the tables of the first rank.
  /// Collective.
  void Deliver(const std::array<vtkTable*, 2>& tables) const
  {
    const int own = this->Group.Own();
    auto pair = this->Own.begin();
    auto away = this->Away.begin();
    for (const Match& match : this->Matches)
    {
      const int working = match.Reference.Rank;
      if (working == own)
      {
        if (match.Mesh.Rank != own)
        {
          this->Group.Send(pair->MeshOutput, match.Mesh.Rank);
        }
        for (std::size_t n = 0; n < tables.size(); ++n)
        {
          if (own == 0)
          {
            AppendPairRows(pair->Rows[n], tables[n]);
          }
          else
          {
            this->Group.Send(pair->Rows[n], 0);
          }
        }
        ++pair;
        continue;
      }
      if (match.Mesh.Rank == own)
      {
        this->Group.Receive(*away++, working);
      }
      for (std::size_t n = 0; own == 0 && n < tables.size(); ++n)
      {
        vtkNew<vtkTable> rows;
        this->Group.Receive(rows, working);
        AppendPairRows(rows, tables[n]);
      }
    }
    assert(pair == this->Own.end() && away == this->Away.end());
  }

private:
  struct Match
  {
    RankedHorizon Reference;
    RankedHorizon Mesh;
  };

  void MatchNames(const std::vector<RankedHorizon>& references, std::vector<RankedHorizon> meshes)
  {
    const bool single = references.size() == 1 && meshes.size() == 1;
    const std::vector<RankedHorizon> all = meshes;
    for (const RankedHorizon& horizon : references)
    {
      const auto match = std::find_if(meshes.begin(), meshes.end(),
        [&](const RankedHorizon& other) { return single || (!horizon.Name.empty() && other.Name == horizon.Name); });
      if (match == meshes.end())
      {
        this->Group.Refuse(NoPartner("mesh", horizon, "reference", all));
      }
      this->Matches.push_back({ horizon, *match });
      meshes.erase(match);
    }
    if (!meshes.empty())
    {
      this->Group.Refuse(NoPartner("reference", meshes.front(), "mesh", references));
    }
  }

  /// All ranks handle all pairs in the same order, so that each message finds its receiver waiting.
  void Take(const Match& match, const std::vector<HorizonLeaf>& references, const std::vector<HorizonLeaf>& meshes)
  {
    const int own = this->Group.Own();
    const bool hasMesh = match.Mesh.Rank == own;
    if (match.Reference.Rank == own)
    {
      const HorizonLeaf& reference = references[match.Reference.Leaf];
      HorizonPair pair{ reference.Name, reference.Input, nullptr, reference.Outputs.front(), nullptr,
        { vtkSmartPointer<vtkTable>::New(), vtkSmartPointer<vtkTable>::New() } };
      if (hasMesh)
      {
        pair.Mesh = meshes[match.Mesh.Leaf].Input;
        pair.MeshOutput = meshes[match.Mesh.Leaf].Outputs.front();
      }
      else
      {
        pair.Mesh = vtkSmartPointer<vtkPolyData>::New();
        pair.MeshOutput = vtkSmartPointer<vtkPolyData>::New();
        this->Group.Receive(pair.Mesh, match.Mesh.Rank);
      }
      this->Own.push_back(pair);
    }
    else if (hasMesh)
    {
      this->Group.Send(meshes[match.Mesh.Leaf].Input, match.Reference.Rank);
      this->Away.push_back(meshes[match.Mesh.Leaf].Outputs.front());
    }
  }

  const Ranks& Group;
  std::vector<Match> Matches; // of all ranks
  std::vector<HorizonPair> Own; // in the order of Matches
  std::vector<vtkPolyData*> Away; // outputs of meshes on other ranks' pairs, in the order of Matches
};
}

vtkStandardNewMacro(vtkHorizonSurfaceDistance);

//------------------------------------------------------------------------------
vtkHorizonSurfaceDistance::vtkHorizonSurfaceDistance()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(port == ReferencePort ? vtkAlgorithm::INPUT_IS_REPEATABLE() : vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port >= FiguresPort ? "vtkTable" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> inputs = ListInputs(inputVector);
  for (const int port : { ReferencePort, MeasuredPort }) // The executive makes the tables.
  {
    vtkDataObject* const input = inputs.empty() ? nullptr : inputs[std::min(std::size_t(port), inputs.size() - 1)];
    MakeOutputLike(input, outputVector->GetInformationObject(port));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceDistance::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::vector<vtkDataObject*> inputs = ListInputs(inputVector);
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    auto* const figures = vtkTable::SafeDownCast(outputs[FiguresPort]);
    auto* const histogram = vtkTable::SafeDownCast(outputs[HistogramPort]);
    const DistanceTables empty = MakeEmptyTables();
    ToVTK(empty.Figures, figures);
    ToVTK(empty.Histogram, histogram);
    PutMeshLast(inputs, outputs, ranks);
    HorizonPairs pairs(inputs[0], inputs[1], outputs[ReferencePort], outputs[MeasuredPort], ranks);
    const std::vector<HorizonPair>& own = pairs.OwnPairs();
    const auto measure = [&]()
    {
      const double size = double(own.size());
      for (std::size_t n = 0; n < own.size(); ++n)
      {
        subject = own[n].Name;
        const Monitor step = monitor.Step(double(n) / size, double(n + 1) / size);
        RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, { own[n].ReferenceOutput, own[n].MeshOutput },
          [&]() { this->MeasurePair(own[n], step); });
      }
    };
    ranks.Together(measure);
    pairs.Deliver({ figures, histogram });
  };
  this->Results.clear();
  const bool isDone = RunRequest(this, outputs, NotEnoughMemory, work, ranks) != 0;
  this->Results = IsAborted(this) ? StoppedReport
    : isDone
    ? TellFigures(vtkTable::SafeDownCast(outputs[FiguresPort]), UnitNames[this->DistanceUnit == World ? WorldUnit : 0])
    : "";
  return isDone ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkHorizonSurfaceDistance::MeasurePair(const HorizonPair& pair, const Monitor& monitor) const
{
  if (pair.Reference->GetNumberOfPoints() + pair.Mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  DistanceStageOptions options;
  options.InWorldUnits = this->DistanceUnit == World;
  options.SamplesPerPoint = this->SamplesPerPoint;
  options.Seed = this->Seed;
  options.Radius = this->Radius;
  options.IncludeFilledPoints = this->IncludeFilledPoints;
  const MeasuredPair measured =
    RunSurfaceDistance(FromVTK(pair.Reference), FromVTK(pair.Mesh), pair.Name, options, monitor);
  ToVTK(measured.Reference, pair.ReferenceOutput);
  ToVTK(measured.Mesh, pair.MeshOutput);
  ToVTK(measured.Rows.Figures, pair.Rows[0]);
  ToVTK(measured.Rows.Histogram, pair.Rows[1]);
}
