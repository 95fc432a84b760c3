// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSealedModel.h"

#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Cutoffs/FaultInput.h"
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
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
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
  this->SetNumberOfOutputPorts(6);
}

//------------------------------------------------------------------------------
vtkHorizonSealedModel::~vtkHorizonSealedModel()
{
  this->SetEndings(nullptr);
  this->SetUnconformities(nullptr);
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
      if (ranks.Own() > 0)
      {
        return;
      }
      const CutInputs inputs = this->ReadInputs(inputVector, subject);
      result = RunSealed(inputs, this->MakeOptions(), monitor);
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
  options.Cutoffs = this->MakeCutOptions();
  options.Endings = this->Endings ? this->Endings : "";
  options.EndDistance = this->EndDistance;
  options.Unconformities = this->Unconformities ? this->Unconformities : "";
  options.GoesThrough = this->Tips == Through;
  options.FollowsOutline = this->Outline == Picks;
  return options;
}
