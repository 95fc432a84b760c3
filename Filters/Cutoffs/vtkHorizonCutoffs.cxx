// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCutoffs.h"

#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "CutoffOutput.h"
#include "CutoffStage.h"
#include "FaultInput.h"
#include "Filters/Faults/GivenLines.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int FaultsPort = 1; // of inputs

enum OutputPort : std::size_t
{
  CutoffsOutput,
  PolygonsOutput,
  PlatesOutput,
  JuxtapositionOutput,
  DiagramsOutput,
  FiguresOutput,
  AreasOutput
};

void WriteOutputs(const CutoffStageResult& result, const std::vector<vtkDataObject*>& outputs)
{
  const auto writeBlocks = [&outputs](const std::vector<Horizon>& blocks, OutputPort port)
  {
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      ToVTK(blocks[n], BlockOf(outputs[port], n));
    }
  };
  writeBlocks(result.Cutoffs, CutoffsOutput);
  writeBlocks(result.Polygons, PolygonsOutput);
  ToVTK(result.Juxtaposition, vtkPolyData::SafeDownCast(outputs[JuxtapositionOutput]));
  ToVTK(result.Diagrams, vtkPolyData::SafeDownCast(outputs[DiagramsOutput]));
  ToVTK(result.Faults, vtkPolyData::SafeDownCast(outputs[PlatesOutput]));
  ToVTK(result.Figures, vtkTable::SafeDownCast(outputs[FiguresOutput]));
  ToVTK(result.Areas, vtkTable::SafeDownCast(outputs[AreasOutput]));
}
}

vtkStandardNewMacro(vtkHorizonCutoffs);

//------------------------------------------------------------------------------
vtkHorizonCutoffs::vtkHorizonCutoffs()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(7);
}

//------------------------------------------------------------------------------
vtkHorizonCutoffs::~vtkHorizonCutoffs() = default;

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(port == FaultsPort ? vtkAlgorithm::INPUT_IS_OPTIONAL() : vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char *const blocks = "vtkPartitionedDataSetCollection", *const surface = "vtkPolyData";
  const std::array<const char*, 7> types = { blocks, blocks, surface, surface, surface, "vtkTable", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[std::size_t(port)]);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes the outputs.
}

//------------------------------------------------------------------------------
// Each process reads all horizons, so that all have the same blocks; the first does the work.
int vtkHorizonCutoffs::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  AskForWhole(inputVector[0]);
  AskForWhole(inputVector[FaultsPort]);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  this->Results.clear();
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    const auto find = [&]()
    {
      std::vector<CutInput> horizons;
      std::vector<std::string> names;
      for (const HorizonLeaf& leaf : ListNamedHorizons(inputVector[0]))
      {
        subject = leaf.Name;
        RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, {},
          [&]() {
            horizons.push_back({ leaf.Name, ReadCutPoints(FromVTK(leaf.Input)) });
          });
      }
      subject.clear();
      vtkDataObject* const faultData = this->GetInputDataObject(FaultsPort, 0);
      GivenFaultPicks given = faultData ? ReadFaultPicks(ListGivenLines(faultData)) : GivenFaultPicks();
      const ArrayTable fields = JoinFields(horizons, given);
      for (const CutInput& horizon : horizons)
      {
        names.push_back(horizon.Name);
      }
      MakeBlocks(names, "Cutoffs", outputs[CutoffsOutput]);
      MakeBlocks(names, "Polygons", outputs[PolygonsOutput]);
      if (ranks.Own() > 0)
      {
        return;
      }
      const CutoffModelData model = RunCutoffs(horizons, given.Picks, this->MakeOptions(), monitor.Step(0.0, 0.9));
      monitor.Progress(0.9);
      const CutoffStageResult result = WriteCutoffs(model, fields);
      WriteOutputs(result, outputs);
      this->Results = result.Report;
      for (const std::vector<std::string>& warnings : { given.Warnings, model.Warnings })
      {
        for (const std::string& warning : warnings)
        {
          vtkWarningMacro(<< warning);
        }
      }
    };
    ranks.Together(find);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}

//------------------------------------------------------------------------------
CutoffStageOptions vtkHorizonCutoffs::MakeOptions() const
{
  CutoffStageOptions options;
  options.Dip = this->Dip;
  options.DropDistance = this->DropDistance;
  options.DropNoise = this->DropNoise;
  options.LargestGap = this->LargestGap;
  options.SmallestLength = this->SmallestLength;
  options.MaximumError =
    this->MaximumError == AutomaticError ? std::nullopt : std::optional<double>(this->MaximumError);
  options.ErrorUnit = static_cast<SeismicHorizons::HeightUnit>(this->HeightUnit);
  return options;
}
