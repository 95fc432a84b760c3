// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRoughSimplification.h"

#include "CellSimplificationStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonRoughSimplification);

//------------------------------------------------------------------------------
void vtkHorizonRoughSimplification::ProcessHorizon(
  const SeismicHorizons::Horizon& horizon, Outputs& outputs, const SeismicHorizons::Monitor& monitor)
{
  const SeismicHorizons::CellOptions options(
    this->GetCellSize(), SeismicHorizons::RepresentativeKind(this->GetRepresentative()), this->GetShowCells());
  SeismicHorizons::RunRoughSimplification(horizon, options, this->GetMaximumNumberOfPoints(), outputs, monitor);
}
