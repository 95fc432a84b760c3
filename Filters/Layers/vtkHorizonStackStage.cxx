// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonStackStage.h"

#include "Common/Horizon/NamedHorizon.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "StackCrossings.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <utility>
#include <vector>

using namespace SeismicHorizons;

//------------------------------------------------------------------------------
vtkHorizonStackStage::~vtkHorizonStackStage()
{
  this->SetCrossingsByLayer(nullptr);
}

//------------------------------------------------------------------------------
HorizonStack vtkHorizonStackStage::ReadStack(vtkInformationVector* inputs, std::string& subject, const Monitor& monitor)
{
  const std::vector<HorizonLeaf> leaves = ListNamedHorizons(inputs);
  HorizonStack stack;
  for (std::size_t n = 0; n < leaves.size(); ++n)
  {
    subject = leaves[n].Name;
    RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, {},
      [&]() { stack.Add(leaves[n].Name, FromVTK(leaves[n].Input)); });
    monitor.Progress(0.5 * double(n + 1) / double(leaves.size()));
  }
  subject.clear();
  stack.PlaceTogether();
  if (!stack.GetDoubt().empty())
  {
    vtkWarningMacro(<< stack.GetDoubt());
  }
  monitor.Progress(0.8);
  OrderStack(this->MakeStackOptions(), stack);
  return stack;
}

//------------------------------------------------------------------------------
StackStageOptions vtkHorizonStackStage::MakeStackOptions() const
{
  StackStageOptions options;
  options.ByHeight = this->Order == ByHeight;
  options.Crossings = static_cast<CrossingPolicy>(this->Crossings);
  options.CrossingsByLayer = this->CrossingsByLayer ? this->CrossingsByLayer : "";
  options.MinimumThickness = this->MinimumThickness;
  options.Unit = this->HeightUnit == World ? SeismicHorizons::HeightUnit::World : SeismicHorizons::HeightUnit::Steps;
  return options;
}

//------------------------------------------------------------------------------
int vtkHorizonStackStage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonStackStage::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes the outputs.
}

//------------------------------------------------------------------------------
// Each process reads all horizons, so that all have the same blocks; the first does the work.
int vtkHorizonStackStage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  AskForWhole(inputVector[0]);
  return 1;
}
