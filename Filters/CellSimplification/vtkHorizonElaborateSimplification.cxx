// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonElaborateSimplification.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonElaborateSimplification);

//------------------------------------------------------------------------------
SeismicHorizons::Reduction vtkHorizonElaborateSimplification::Simplify(
  const SeismicHorizons::BoundedHorizon& horizon, vtkFieldData* chosen, const SeismicHorizons::Monitor& monitor)
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
  if (this->GetMaximumNumberOfPoints() == 0)
  {
    return SeismicHorizons::SimplifyElaborate(horizon, options, monitor);
  }
  SeismicHorizons::Reduction reduction =
    SeismicHorizons::SimplifyElaborateTo(std::size_t(this->GetMaximumNumberOfPoints()), horizon, options, monitor);
  SeismicHorizons::AddValue<vtkIntArray>(chosen, SeismicHorizons::FieldArray::ChosenCellSize, options.CellSize);
  SeismicHorizons::AddValue<vtkDoubleArray>(
    chosen, SeismicHorizons::FieldArray::ChosenFlatnessThreshold, options.FlatnessThreshold);
  return reduction;
}
