// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonReducedMesh.h"

#include "DecimationStage.h"

using namespace SeismicHorizons;

//------------------------------------------------------------------------------
ReducedMeshOptions vtkHorizonReducedMesh::MakeMeshOptions(bool isWithinError) const
{
  ReducedMeshOptions options;
  options.FitHeights = this->FitHeights;
  options.Effort = this->Effort == Fast ? DecimationEffort::Fast : DecimationEffort::Best;
  options.Priority =
    this->Priority == LargestErrors ? DecimationPriority::LargestError : DecimationPriority::SumOfSquares;
  options.SmallestAngle = this->SmallestAngle;
  options.EdgeLength = isWithinError ? this->EdgeLength : 0.0;
  options.EdgeGrowth = this->EdgeGrowth;
  options.Crossings = static_cast<SeismicHorizons::CrossingTolerance>(this->CrossingTolerance);
  options.MaximumError =
    this->MaximumError == AutomaticError ? std::nullopt : std::optional<double>(this->MaximumError);
  options.ErrorUnit = static_cast<HeightUnit>(this->ErrorUnit);
  options.CloseFaults = this->CloseFaults;
  return options;
}
