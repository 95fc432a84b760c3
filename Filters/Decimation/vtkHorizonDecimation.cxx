// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDecimation.h"

#include "DecimationStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonDecimation);

//------------------------------------------------------------------------------
void vtkHorizonDecimation::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  DecimationStageOptions options;
  static_cast<ReducedMeshOptions&>(options) = this->MakeMeshOptions(this->Target == LargestError);
  options.Target = static_cast<DecimationTarget>(this->Target);
  options.MaximumNumberOfPoints = this->MaximumNumberOfPoints;
  options.TargetReduction = this->TargetReduction;
  RunDecimation(horizon, options, outputs, monitor);
}
