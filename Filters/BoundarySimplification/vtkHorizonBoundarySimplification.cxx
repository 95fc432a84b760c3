// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonBoundarySimplification.h"

#include "BoundarySimplificationStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonBoundarySimplification);

//------------------------------------------------------------------------------
void vtkHorizonBoundarySimplification::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  BoundarySimplificationOptions options;
  options.Method = this->Method == Threshold ? OutlineMethod::Threshold : OutlineMethod::FewestPoints;
  options.DistanceThreshold = this->DistanceThreshold;
  options.BoundDeviation = this->BoundDeviation;
  options.OutlineTolerance = this->OutlineTolerance;
  RunBoundarySimplification(horizon, options, outputs, monitor);
}
