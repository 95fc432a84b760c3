// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRoughSimplification.h"

#include "CellSimplification/RoughSimplification.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonRoughSimplification);

//------------------------------------------------------------------------------
SeismicHorizons::Reduction vtkHorizonRoughSimplification::Simplify(
  const SeismicHorizons::BoundedHorizon& horizon, const SeismicHorizons::Monitor& monitor)
{
  const SeismicHorizons::CellOptions options(
    this->GetCellSize(), SeismicHorizons::RepresentativeKind(this->GetRepresentative()), this->GetShowCells());
  return SeismicHorizons::SimplifyRough(horizon, options, monitor);
}
