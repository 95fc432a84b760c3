// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFaults.h"

#include "Common/Horizon/DataModel.h"
#include "FaultStage.h"
#include "GivenLines.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int GivenPort = 1;
}

vtkStandardNewMacro(vtkHorizonFaults);

//------------------------------------------------------------------------------
vtkHorizonFaults::vtkHorizonFaults()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkHorizonFaults::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->MeasuredNoise = 0.0;
  this->NumberOfFaultLines = 0;
  this->NumberOfFaultedLinks = 0;
  this->Given.reset();
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (this->Given)
  {
    this->Warn(this->Given->Warnings());
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkHorizonFaults::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  FaultStageOptions options;
  options.SmallestThrow = this->SmallestThrow;
  options.Noise = this->Noise;
  options.SmallestExtent = this->SmallestExtent;
  options.SmallestBranch = this->SmallestBranch;
  options.LargestGap = this->LargestGap;
  options.LargestRamp = this->LargestRamp;
  options.JoinThroughHoles = this->JoinThroughHoles;
  options.Detect = this->Detect;
  options.ThrowUnit = static_cast<HeightUnit>(this->ThrowUnit);
  vtkDataObject* const lines = this->GetInputDataObject(GivenPort, 0);
  options.AreSticks = lines && this->LineType == Sticks;
  options.ExtendSticks = this->ExtendSticks;
  options.Polygons = static_cast<PolygonUse>(this->Polygons);
  if (!this->Given)
  {
    this->Given = std::make_shared<GivenFaults>(ListGivenLines(lines));
  }
  const bool isFirst = !this->Given->HaveHorizons();
  RunFaults(horizon, *this->Given, options, outputs, monitor);
  if (!isFirst) // All horizons have the same fault surfaces.
  {
    Horizon& surfaces = outputs[2];
    const ArrayTable figures = surfaces.FieldData;
    surfaces = Horizon();
    surfaces.FieldData = figures;
  }
  const ArrayTable& figures = outputs.front().FieldData;
  if (this->Detect)
  {
    this->MeasuredNoise = std::max(this->MeasuredNoise, FirstValue(figures, FieldArray::FaultNoise));
  }
  const DataArray* const numbers = outputs[1].CellData.Find(CellArray::FaultLine);
  this->NumberOfFaultLines += numbers->Tuples();
  this->NumberOfFaultedLinks += figures.Find(FieldArray::FaultedLinks)->Tuples();
}
