// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonExteriorBoundary.h"

#include "BoundaryStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonExteriorBoundary);

//------------------------------------------------------------------------------
void vtkHorizonExteriorBoundary::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  BoundaryStageOptions options;
  options.Radius = this->Radius;
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.KeepHoles = this->KeepHoles;
  options.SmallestHoleSize = this->SmallestHoleSize;
  options.SmallestHoleArea = this->SmallestHoleArea;
  options.MinimumPatchSize = this->MinimumPatchSize;
  options.Type = static_cast<SeismicHorizons::BoundaryType>(this->BoundaryType);
  options.TearAtFaults = this->TearAtFaults;
  this->Warn(RunBoundary(horizon, options, outputs, monitor));
}
