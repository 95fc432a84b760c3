// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonElaborateSimplification.h"

#include "CellSimplification/ElaborateSimplification.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonElaborateSimplification);

//------------------------------------------------------------------------------
void vtkHorizonElaborateSimplification::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FlatnessThreshold: " << this->FlatnessThreshold << "\n";
  os << indent << "BoundaryDensityThreshold: " << this->BoundaryDensityThreshold << "\n";
  os << indent << "BoundaryExtentThreshold: " << this->BoundaryExtentThreshold << "\n";
  os << indent << "BoundaryCellSizeThreshold: " << this->BoundaryCellSizeThreshold << "\n";
  os << indent << "SmallestCellSize: " << this->SmallestCellSize << "\n";
  os << indent << "NeighbourMean: " << (this->NeighbourMean == OverCubes ? "OverCubes" : "OverPieces") << "\n";
  os << indent << "GrowthPerRing: " << this->GrowthPerRing << "\n";
}

//------------------------------------------------------------------------------
SeismicHorizons::Reduction vtkHorizonElaborateSimplification::Simplify(
  const SeismicHorizons::BoundedHorizon& horizon, const SeismicHorizons::Monitor& monitor)
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
  return SeismicHorizons::SimplifyElaborate(horizon, options, monitor);
}
