// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonHoleFilling.h"

#include "Common/Horizon/DataModel.h"
#include "HoleFillingStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonHoleFilling);

//------------------------------------------------------------------------------
int vtkHorizonHoleFilling::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfFilledHoles = 0;
  this->NumberOfFilledPoints = 0;
  this->NumberOfOpenHoles = 0;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonHoleFilling::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  HoleFillingStageOptions options;
  options.LargestHoleSize = this->LargestHoleSize;
  options.LargestHoleArea = this->LargestHoleArea;
  options.Method = static_cast<FillMethod>(this->Method);
  options.RimSmoothing = this->RimSmoothing;
  options.RimWidth = this->RimWidth;
  options.ExtrapolationDistance = this->ExtrapolationDistance;
  options.FillAttributes = this->Attributes == FromRim;
  RunHoleFilling(horizon, options, outputs, monitor);
  const ArrayTable& figures = outputs.front().FieldData;
  this->NumberOfFilledHoles += vtkIdType(FirstValue(figures, FieldArray::NumberOfFilledHoles));
  this->NumberOfFilledPoints += vtkIdType(FirstValue(figures, FieldArray::NumberOfFilledPoints));
  this->NumberOfOpenHoles += vtkIdType(FirstValue(figures, FieldArray::NumberOfOpenHoles));
}
