// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTriangulation.h"

#include "TriangulationStage.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonTriangulation);

//------------------------------------------------------------------------------
vtkHorizonTriangulation::vtkHorizonTriangulation()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHorizonTriangulation::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  TriangulationStageOptions options;
  options.Strategy = static_cast<SeismicHorizons::SearchStrategy>(this->SearchStrategy);
  options.ConvexHull = this->ConvexHull;
  options.Limits = { this->MaximumBoundaryAngle, this->MaximumBoundaryEdgeLength };
  options.MostTriangles = this->MaximumNumberOfTriangles;
  options.CloseFaults = this->CloseFaults;
  RunTriangulation(horizon, options, outputs, monitor);
}
