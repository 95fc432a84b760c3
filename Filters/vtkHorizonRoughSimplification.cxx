// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRoughSimplification.h"

#include "HorizonData.h"
#include "RoughSimplification.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHorizonRoughSimplification);

//------------------------------------------------------------------------------
void vtkHorizonRoughSimplification::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize << "\n";
}

//------------------------------------------------------------------------------
void vtkHorizonRoughSimplification::ProcessHorizon(
  vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor)
{
  const SeismicHorizons::LatticePoints points = SeismicHorizons::ReadPoints(input);
  const SeismicHorizons::BoundedHorizon horizon = SeismicHorizons::ReadBoundedHorizon(input, points);
  monitor.Progress(0.2);
  const SeismicHorizons::Reduction reduction =
    SeismicHorizons::SimplifyRough(horizon, this->CellSize, monitor.Step(0.2, 0.8));
  SeismicHorizons::WriteReduction(input, points.Grid, reduction, SeismicHorizons::Merging::AveragesPoints, output);
}
