// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDespiking.h"

#include "Common/Horizon/DataModel.h"
#include "DespikingStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonDespiking);

//------------------------------------------------------------------------------
vtkHorizonDespiking::vtkHorizonDespiking()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkHorizonDespiking::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfSpikes = 0;
  this->NumberOfSpurPoints = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonDespiking::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  DespikingStageOptions options;
  options.Threshold = this->Threshold;
  options.ThresholdUnit = static_cast<HeightUnit>(this->ThresholdUnit);
  options.Radius = this->NeighborhoodRadius;
  options.SpurWidth = this->SpurWidth;
  options.Remove = this->Action == Remove;
  this->Warn(RunDespiking(horizon, options, outputs, monitor));
  const ArrayTable& figures = outputs.front().FieldData;
  this->NumberOfSpikes += vtkIdType(FirstValue(figures, FieldArray::NumberOfSpikes));
  this->NumberOfSpurPoints += vtkIdType(FirstValue(figures, FieldArray::NumberOfSpurPoints));
}
