// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonLayers.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/HeightNoise.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Algorithms/Despiking/Despiking.h"
#include "Filters/Algorithms/Layers/LayerBody.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "Filters/Algorithms/Layers/LayerPlan.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "HorizonStack.h"
#include "LayerFigures.h"
#include "LayerOutput.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
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

void RequireFullColumns(const HorizonStack& stack)
{
  for (std::size_t n = 0; n < stack.Size(); ++n)
  {
    const int radius = ChooseRadius(stack[n].Placed.Columns);
    if (radius > 1)
    {
      throw InputError(stack[n].Name + " with steps of " + std::to_string(radius) +
        " columns from point to point, expected 1 for the domain EachLayer: choose Common, or Missing Interpolate");
    }
  }
}
}

vtkStandardNewMacro(vtkHorizonLayers);

//------------------------------------------------------------------------------
vtkHorizonLayers::vtkHorizonLayers()
{
  this->SetNumberOfOutputPorts(5);
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
      if (stack.GetSurvey().VerticalDomain == "time")
      {
        vtkWarningMacro(<< "z is time, so that volumes are areas times time, expected depths for volumes: convert the "
                           "horizons to depth before");
      }
      LayerOptions options = this->MakeOptions(stack);
      const ErrorLimit limit = this->FindMaximumError(stack);
      options.MaximumError = limit.Indices;
      if (options.Domain == LayerDomain::EachLayer && this->Missing == Void)
      {
        RequireFullColumns(stack);
      }
      const std::optional<LinkCuts> cuts = this->UseCuts ? stack.FindCuts() : std::nullopt;
      options.Cuts = cuts ? &*cuts : nullptr;
      const Layers layers = MakeLayers(stack.Views(), options, monitor.Step(0.1, 0.7));
      this->Write(layers, stack, outputs, monitor.Step(0.7, 1.0));
      if (limit.Noise)
      {
        vtkFieldData* const figures = outputs[LayersPort]->GetFieldData();
        AddValue<vtkDoubleArray>(figures, FieldArray::ChosenMaximumError, limit.Indices);
        WriteHeightNoise(*limit.Noise, figures);
        std::ostringstream text;
        const std::string unit = stack.GetSurvey().VerticalUnit;
        text << "maximum error " << limit.Indices * WorldPerIndex(stack.CommonLattice()) << ' '
             << (unit.empty() ? "in z" : unit) << ", six times the " << (limit.Noise->IsRounding ? "rounding" : "noise")
             << "\n";
        this->Results += text.str();
      }
      this->WarnOfCrossings(layers.Stack.Repair, options.Crossings.Policies, stack);
    };
    ranks.Together(make);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}

//------------------------------------------------------------------------------
ErrorLimit vtkHorizonLayers::FindMaximumError(const HorizonStack& stack) const
{
  if (this->MaximumError != AutomaticError)
  {
    CheckAtLeast("maximum error", this->MaximumError, 0.0, ", or -1 for automatic");
    return { this->IndicesOf(this->MaximumError, stack), std::nullopt };
  }
  HeightNoise most;
  for (std::size_t n = 0; n < stack.Size(); ++n)
  {
    const HeightNoise noise = MeasureHeightNoise(stack[n].Placed.Columns, stack[n].Placed.Height);
    most = noise.Deviation > most.Deviation ? noise : most;
  }
  return { most.MaximumError(), most };
}

//------------------------------------------------------------------------------
LayerOptions vtkHorizonLayers::MakeOptions(const HorizonStack& stack) const
{
  CheckAtLeast("smallest pinch", this->SmallestPinch, 1, " column");
  CheckAtLeast("largest hole size", this->LargestHoleSize, 0, " columns");
  CheckWithin("largest gap", this->LargestGap, 0, 255, " columns");
  if (!std::isfinite(this->Contact))
  {
    throw InputError("contact " + std::to_string(this->Contact) + ", expected a finite number");
  }
  LayerOptions options;
  options.Crossings = this->MakeCrossings(stack);
  options.BoundThickness = this->BoundThickness;
  const bool isCommon = this->Domain == Common || stack.Size() == 2;
  options.Domain = isCommon ? LayerDomain::Common : LayerDomain::EachLayer;
  options.Missing = { static_cast<MissingPolicy>(this->Missing), this->LargestHoleSize, this->LargestGap };
  if (isCommon && this->KeepOutlines)
  {
    options.OutlineTolerance = 0.0;
    options.SmallestHoleSize = 1;
  }
  options.PinchOutLines = this->PinchOutLines;
  options.SmallestPinch = this->SmallestPinch;
  options.FitHeights = this->FitHeights;
  options.Effort = this->Effort == Fast ? DecimationEffort::Fast : DecimationEffort::Best;
  options.SmallestAngle = this->SmallestAngle;
  return options;
}

//------------------------------------------------------------------------------
void vtkHorizonLayers::Write(
  const Layers& layers, const HorizonStack& stack, const std::vector<vtkDataObject*>& outputs, const Monitor& monitor)
{
  const LayerPlan& plan = layers.Plan;
  const auto numberOf = double(plan.NumberOfHorizons());
  const auto part = [numberOf](std::size_t n) { return double(n) / numberOf; };
  const LayerCells cells = MakeLayerCells(plan, monitor.Step(0.0, 0.15));
  WriteLayerCells(cells, plan, stack, vtkUnstructuredGrid::SafeDownCast(outputs[LayersPort]));
  std::vector<LayerVolume> volumes;
  for (std::size_t layer = 0; layer < plan.NumberOfLayers(); ++layer)
  {
    const Monitor step = monitor.Step(0.2, 0.6).Step(part(layer), part(layer + 1));
    vtkPolyData* const body = BlockOf(outputs[BodiesPort], layer);
    WriteLayerBody(MakeLayerBody(plan, layer, step.Step(0.0, 0.9)), plan, layer, stack, body);
    WriteLayerLedger(layers.Ledgers.OfLayers[layer], stack, body->GetFieldData());
    volumes.push_back(MeasureLayer(plan, layer));
    step.Progress(1.0);
  }
  for (std::size_t horizon = 0; horizon < plan.NumberOfHorizons(); ++horizon)
  {
    WriteLayerHorizon(layers, cells, horizon, stack, BlockOf(outputs[HorizonsPort], horizon));
    monitor.Step(0.6, 0.85).Progress(part(horizon + 1));
  }
  WriteLayerTable(layers, volumes, stack,
    this->MeasureAboveContact ? std::optional<double>(this->Contact) : std::nullopt,
    vtkTable::SafeDownCast(outputs[TablePort]));
  vtkTable* const curve = vtkTable::SafeDownCast(outputs[CurvePort]);
  WriteVolumeCurve(plan, stack, curve, monitor.Step(0.85, 1.0));
  this->WarnOfContact(curve);
  this->Results = ReportLayers(layers, volumes, stack);
  this->WarnOfEmpty(volumes, stack);
  const char* const ofDomain = this->Domain == EachLayer ? "" : ": Domain EachLayer leaves out less";
  const char* const advice = this->Missing == Follow ? ofDomain : ": Missing Follow leaves out less";
  for (const std::string& text : ReportMissing(layers.Ledgers, stack, advice))
  {
    vtkWarningMacro(<< text);
  }
}

//------------------------------------------------------------------------------
void vtkHorizonLayers::WarnOfEmpty(const std::vector<LayerVolume>& volumes, const HorizonStack& stack)
{
  std::vector<std::string> empty;
  for (std::size_t layer = 0; layer < volumes.size(); ++layer)
  {
    if (volumes[layer].Volume == 0.0)
    {
      empty.push_back(NamesOfLayers(stack)[layer]);
    }
  }
  if (!empty.empty())
  {
    vtkWarningMacro(
      << empty.front() << (empty.size() > 1 ? ", and " + std::to_string(empty.size() - 1) + " more," : "")
      << " without a cell, expected horizons that are apart by more than the error over an area that both have");
  }
}

//------------------------------------------------------------------------------
void vtkHorizonLayers::WarnOfContact(vtkTable* curve)
{
  vtkDataArray* const contacts = vtkDataArray::SafeDownCast(curve->GetColumnByName("Contact"));
  if (!this->MeasureAboveContact || !contacts)
  {
    return;
  }
  const double* const range = contacts->GetRange(0);
  if (this->Contact < range[0] || this->Contact > range[1])
  {
    vtkWarningMacro(<< "contact " << this->Contact << (this->Contact > range[1] ? " above" : " below")
                    << " all layers, expected a z from " << range[0] << " to " << range[1]
                    << ": depths and times are negative");
  }
}

//------------------------------------------------------------------------------
void vtkHorizonLayers::WarnOfCrossings(
  const CrossingRepair& repair, const std::vector<CrossingPolicy>& policies, const HorizonStack& stack)
{
  constexpr double MostOfNoise = 6.0; // that noise makes horizons cross by
  std::vector<std::optional<double>> noise(stack.Size());
  const auto noiseOf = [&](std::size_t horizon)
  {
    if (!noise[horizon])
    {
      noise[horizon] = MeasureNoise(stack[horizon].Placed.Columns, stack[horizon].Placed.Height);
    }
    return *noise[horizon];
  };
  const auto depthOf = [&](std::size_t layer) { return repair.Interfaces[layer].Largest; };
  std::size_t deep = 0; // crossings
  std::size_t deepest = 0; // the layer of the deepest of these
  for (std::size_t layer = 0; layer < repair.Interfaces.size(); ++layer)
  {
    const bool isMean = policies[std::min(layer, policies.size() - 1)] == CrossingPolicy::Mean;
    if (isMean && depthOf(layer) > 1.0 &&
      depthOf(layer) > 1.0 + MostOfNoise * std::hypot(noiseOf(layer), noiseOf(layer + 1)))
    {
      deepest = deep == 0 || depthOf(layer) > depthOf(deepest) ? layer : deepest;
      ++deep;
    }
  }
  if (deep > 0)
  {
    const std::string unit = stack.GetSurvey().VerticalUnit;
    vtkWarningMacro(<< stack[deepest].Name << " and " << stack[deepest + 1].Name
                    << (deep > 1 ? ", and " + std::to_string(deep - 1) + " other pairs," : "") << " cross by up to "
                    << depthOf(deepest) * WorldPerIndex(stack.CommonLattice()) << (unit.empty() ? "" : " ") << unit
                    << ", expected no more than their noise makes: at an unconformity choose UpperWins or LowerWins");
  }
}
