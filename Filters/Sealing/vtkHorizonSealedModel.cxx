// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSealedModel.h"

#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Cutoffs/CutoffStage.h"
#include "Filters/Cutoffs/FaultInput.h"
#include "Filters/Faults/GivenLines.h"
#include "SealedStage.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int SealedFaultsPort = 1; // of inputs

enum SealedPort : std::size_t
{
  SurfacesOutput,
  LinesOutput,
  BodiesOutput,
  BodyFiguresOutput,
  FaultAreasOutput,
  PicksOutput
};
}

vtkStandardNewMacro(vtkHorizonSealedModel);

//------------------------------------------------------------------------------
vtkHorizonSealedModel::vtkHorizonSealedModel()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(6);
}

//------------------------------------------------------------------------------
vtkHorizonSealedModel::~vtkHorizonSealedModel()
{
  this->SetEndings(nullptr);
  this->SetUnconformities(nullptr);
}

//------------------------------------------------------------------------------
int vtkHorizonSealedModel::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(port == SealedFaultsPort ? vtkAlgorithm::INPUT_IS_OPTIONAL() : vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonSealedModel::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char *const surface = "vtkPolyData", *const table = "vtkTable";
  const std::array<const char*, 6> types = { surface, surface, "vtkPartitionedDataSetCollection", table, table, table };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[std::size_t(port)]);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonSealedModel::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes the outputs.
}

//------------------------------------------------------------------------------
int vtkHorizonSealedModel::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  AskForWhole(inputVector[0]);
  AskForWhole(inputVector[SealedFaultsPort]);
  return 1;
}

//------------------------------------------------------------------------------
// The first process makes the model, and sends the names of bodies, so that all have the same blocks.
int vtkHorizonSealedModel::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  this->Results.clear();
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    SealedStageResult result;
    const auto seal = [&]()
    {
      std::vector<CutInput> horizons;
      if (ranks.Own() > 0)
      {
        return;
      }
      for (const HorizonLeaf& leaf : ListNamedHorizons(inputVector[0]))
      {
        subject = leaf.Name;
        RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, {},
          [&]() {
            horizons.push_back({ leaf.Name, ReadCutPoints(FromVTK(leaf.Input)) });
          });
      }
      subject.clear();
      vtkDataObject* const faultData = this->GetInputDataObject(SealedFaultsPort, 0);
      GivenFaultPicks given = faultData ? ReadFaultPicks(ListGivenLines(faultData)) : GivenFaultPicks();
      const ArrayTable fields = JoinFields(horizons, given);
      result = RunSealed(horizons, given.Picks, fields, this->MakeOptions(), monitor);
      result.Warnings.insert(result.Warnings.begin(), given.Warnings.begin(), given.Warnings.end());
    };
    ranks.Together(seal);
    std::ostringstream lines;
    std::copy(result.BodyNames.begin(), result.BodyNames.end(), std::ostream_iterator<std::string>(lines, "\n"));
    std::istringstream told(ranks.Gather(lines.str()).front());
    result.BodyNames.clear();
    for (std::string name; std::getline(told, name);)
    {
      result.BodyNames.push_back(name);
    }
    MakeBlocks(result.BodyNames, "Body", outputs[BodiesOutput]);
    if (ranks.Own() > 0)
    {
      return;
    }
    ToVTK(result.Surfaces, vtkPolyData::SafeDownCast(outputs[SurfacesOutput]));
    ToVTK(result.Lines, vtkPolyData::SafeDownCast(outputs[LinesOutput]));
    for (std::size_t body = 0; body < result.Bodies.size(); ++body)
    {
      ToVTK(result.Bodies[body], BlockOf(outputs[BodiesOutput], body));
    }
    ToVTK(result.Figures, vtkTable::SafeDownCast(outputs[BodyFiguresOutput]));
    ToVTK(result.Areas, vtkTable::SafeDownCast(outputs[FaultAreasOutput]));
    ToVTK(result.Picks, vtkTable::SafeDownCast(outputs[PicksOutput]));
    this->Results = result.Report;
    for (const std::string& warning : result.Warnings)
    {
      vtkWarningMacro(<< warning);
    }
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}

//------------------------------------------------------------------------------
SealedStageOptions vtkHorizonSealedModel::MakeOptions() const
{
  SealedStageOptions options;
  options.Endings = this->Endings ? this->Endings : "";
  options.EndDistance = this->EndDistance;
  options.Unconformities = this->Unconformities ? this->Unconformities : "";
  options.Cutoffs.Dip = this->Dip;
  options.Cutoffs.DropDistance = this->DropDistance;
  options.Cutoffs.DropNoise = this->DropNoise;
  options.Cutoffs.MaximumError =
    this->MaximumError == AutomaticError ? std::nullopt : std::optional<double>(this->MaximumError);
  options.Cutoffs.ErrorUnit = static_cast<SeismicHorizons::HeightUnit>(this->HeightUnit);
  return options;
}
