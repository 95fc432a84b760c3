// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonElaborateSimplification.h"

#include "CellSimplificationStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonElaborateSimplification);

//------------------------------------------------------------------------------
void vtkHorizonElaborateSimplification::ProcessHorizon(
  const SeismicHorizons::Horizon& horizon, Outputs& outputs, const SeismicHorizons::Monitor& monitor)
{
  SeismicHorizons::ElaborateOptions options(this->GetCellSize(), this->FlatnessThreshold);
  options.Representative = SeismicHorizons::RepresentativeKind(this->GetRepresentative());
  options.ListCells = this->GetShowCells();
  options.BoundaryDensityThreshold = this->BoundaryDensityThreshold;
  options.BoundaryExtentThreshold = this->BoundaryExtentThreshold;
  options.BoundaryCellSizeThreshold = this->BoundaryCellSizeThreshold;
  options.SmallestCellSize = this->SmallestCellSize;
  options.NeighbourMean = SeismicHorizons::NeighbourMeanKind(this->NeighbourMean);
  options.GrowthPerRing = this->GrowthPerRing;
  SeismicHorizons::RunElaborateSimplification(horizon, options, this->GetMaximumNumberOfPoints(), outputs, monitor);
}
