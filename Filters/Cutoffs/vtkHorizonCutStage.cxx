// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCutStage.h"

#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "CutoffStage.h"
#include "FaultInput.h"
#include "Filters/Faults/GivenLines.h"

#include "vtkInformation.h"

#include <optional>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int FaultsPort = 1; // of inputs
}

//------------------------------------------------------------------------------
vtkHorizonCutStage::vtkHorizonCutStage()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkHorizonCutStage::~vtkHorizonCutStage() = default;

//------------------------------------------------------------------------------
int vtkHorizonCutStage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(port == FaultsPort ? vtkAlgorithm::INPUT_IS_OPTIONAL() : vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonCutStage::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes the outputs.
}

//------------------------------------------------------------------------------
// Each process may read all horizons, so that all have the same blocks; the first does the work.
int vtkHorizonCutStage::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  AskForWhole(inputVector[0]);
  AskForWhole(inputVector[FaultsPort]);
  return 1;
}

//------------------------------------------------------------------------------
CutInputs vtkHorizonCutStage::ReadInputs(vtkInformationVector** inputVector, std::string& subject)
{
  std::vector<CutInput> horizons;
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
  return JoinCutInputs(std::move(horizons), faultData ? std::make_optional(ListGivenLines(faultData)) : std::nullopt);
}

//------------------------------------------------------------------------------
CutoffStageOptions vtkHorizonCutStage::MakeCutOptions() const
{
  CutoffStageOptions options;
  options.Dip = this->Dip;
  options.DropDistance = this->DropDistance;
  options.DropNoise = this->DropNoise;
  options.MaximumError =
    this->MaximumError == AutomaticError ? std::nullopt : std::optional<double>(this->MaximumError);
  options.ErrorUnit = static_cast<SeismicHorizons::HeightUnit>(this->HeightUnit);
  return options;
}
