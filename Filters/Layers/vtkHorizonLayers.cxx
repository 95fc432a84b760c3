// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonLayers.h"

#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Common/VTK/VolumeConversion.h"
#include "LayerFigures.h"
#include "LayerStage.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr std::size_t LayersPort = 0;
constexpr std::size_t BodiesPort = 1;
constexpr std::size_t HorizonsPort = 2;
constexpr std::size_t TablePort = 3;
constexpr std::size_t CurvePort = 4;

void WriteOutputs(const LayerStageResult& result, const std::vector<vtkDataObject*>& outputs)
{
  ToVTK(result.Layers, vtkUnstructuredGrid::SafeDownCast(outputs[LayersPort]));
  for (std::size_t layer = 0; layer < result.Bodies.size(); ++layer)
  {
    ToVTK(result.Bodies[layer], BlockOf(outputs[BodiesPort], layer));
  }
  for (std::size_t horizon = 0; horizon < result.Horizons.size(); ++horizon)
  {
    ToVTK(result.Horizons[horizon], BlockOf(outputs[HorizonsPort], horizon));
  }
  ToVTK(result.Figures, vtkTable::SafeDownCast(outputs[TablePort]));
  ToVTK(result.Volumes, vtkTable::SafeDownCast(outputs[CurvePort]));
}
}

vtkStandardNewMacro(vtkHorizonLayers);

//------------------------------------------------------------------------------
vtkHorizonLayers::vtkHorizonLayers()
{
  this->SetNumberOfOutputPorts(5);
}

//------------------------------------------------------------------------------
vtkHorizonLayers::~vtkHorizonLayers()
{
  this->SetSublayers(nullptr);
}

//------------------------------------------------------------------------------
int vtkHorizonLayers::FillOutputPortInformation(int port, vtkInformation* info)
{
  const std::array<const char*, 5> types = { "vtkUnstructuredGrid", "vtkPartitionedDataSetCollection",
    "vtkPartitionedDataSetCollection", "vtkTable", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[std::size_t(port)]);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonLayers::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  this->Results.clear();
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    const auto make = [&]()
    {
      const HorizonStack stack = this->ReadStack(inputVector[0], subject, monitor.Step(0.0, 0.1));
      subject.clear();
      monitor.Progress(0.1);
      MakeBlocks(NamesOfLayers(stack), "Layers", outputs[BodiesPort]);
      MakeBlocks(stack.Names(), "Horizons", outputs[HorizonsPort]);
      if (ranks.Own() > 0)
      {
        return;
      }
      const std::string doubt = WarnOfTime(stack);
      if (!doubt.empty())
      {
        vtkWarningMacro(<< doubt);
      }
      const LayerStageResult result = RunLayers(stack, this->MakeOptions(), monitor);
      WriteOutputs(result, outputs);
      this->Results = result.Report;
      for (const std::string& warning : result.Warnings)
      {
        vtkWarningMacro(<< warning);
      }
    };
    ranks.Together(make);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}

//------------------------------------------------------------------------------
LayerStageOptions vtkHorizonLayers::MakeOptions() const
{
  LayerStageOptions options;
  static_cast<StackStageOptions&>(options) = this->MakeStackOptions();
  options.MaximumError =
    this->MaximumError == AutomaticError ? std::nullopt : std::optional<double>(this->MaximumError);
  options.BoundThickness = this->BoundThickness;
  options.PinchOutLines = this->PinchOutLines;
  options.SmallestPinch = this->SmallestPinch;
  options.Domain = this->Domain == Common ? LayerDomain::Common : LayerDomain::EachLayer;
  options.KeepOutlines = this->KeepOutlines;
  options.TearAtFaults = this->TearAtFaults;
  options.Missing = static_cast<MissingPolicy>(this->Missing);
  options.LargestHoleSize = this->LargestHoleSize;
  options.LargestGap = this->LargestGap;
  options.Effort = this->Effort == Fast ? DecimationEffort::Fast : DecimationEffort::Best;
  options.SmallestAngle = this->SmallestAngle;
  options.EdgeLength = this->EdgeLength;
  options.EdgeGrowth = this->EdgeGrowth;
  options.FitHeights = this->FitHeights;
  options.Sublayers = this->Sublayers ? this->Sublayers : "";
  options.LargestSublayerThickness = this->LargestSublayerThickness;
  options.Tetrahedra = this->Tetrahedra;
  if (this->MeasureAboveContact || !std::isfinite(this->Contact)) // The stage refuses other numbers.
  {
    options.Contact = this->Contact;
  }
  return options;
}
