// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRoughSimplification.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Algorithms/CellSimplification/CellSimplification.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonRoughSimplification);

//------------------------------------------------------------------------------
SeismicHorizons::Reduction vtkHorizonRoughSimplification::Simplify(
  const SeismicHorizons::BoundedHorizon& horizon, vtkFieldData* chosen, const SeismicHorizons::Monitor& monitor)
{
  SeismicHorizons::CellOptions options(
    this->GetCellSize(), SeismicHorizons::RepresentativeKind(this->GetRepresentative()), this->GetShowCells());
  if (this->GetMaximumNumberOfPoints() == 0)
  {
    return SeismicHorizons::SimplifyRough(horizon, options, monitor);
  }
  SeismicHorizons::Reduction reduction =
    SeismicHorizons::SimplifyRoughTo(std::size_t(this->GetMaximumNumberOfPoints()), horizon, options, monitor);
  SeismicHorizons::AddValue<vtkIntArray>(chosen, SeismicHorizons::FieldArray::ChosenCellSize, options.CellSize);
  return reduction;
}
