// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTriangulation.h"

#include "HorizonData.h"
#include "Triangulation.h"

#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkHorizonTriangulation);

//------------------------------------------------------------------------------
void vtkHorizonTriangulation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkHorizonTriangulation::ProcessHorizon(
  vtkPolyData* input, vtkPolyData* output, const SeismicHorizons::Monitor& monitor)
{
  const SeismicHorizons::LatticePoints points = SeismicHorizons::ReadPoints(input);
  const SeismicHorizons::BoundedHorizon horizon = SeismicHorizons::ReadBoundedHorizon(input, points);
  monitor.Progress(0.1);
  std::vector<SeismicHorizons::PointId> triangles = SeismicHorizons::Triangulate(horizon, monitor.Step(0.1, 0.9));
  // On a mirrored lattice what is counter-clockwise there is clockwise in the world.
  for (std::size_t corner = 0; !points.Grid.KeepsOrientation() && corner < triangles.size(); corner += 3)
  {
    std::swap(triangles[corner + 1], triangles[corner + 2]);
  }
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->SetLines(input->GetLines());
  output->SetPolys(SeismicHorizons::MakeTriangles(triangles));
}
