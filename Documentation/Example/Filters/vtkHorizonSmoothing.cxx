// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSmoothing.h"

#include "Smoothing.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The map from columns and vertical indices to the world, which each horizon carries in its field data.
void ReadMap(vtkPolyData* horizon, vtkMatrix4x4* map)
{
  vtkDataArray* const values = horizon->GetFieldData()->GetArray("LatticeToWorld");
  if (!values || values->GetNumberOfValues() != 16)
  {
    throw SeismicHorizons::InputError("no 16 numbers LatticeToWorld in the field data, expected those of a horizon");
  }
  for (int n = 0; n < 16; ++n)
  {
    map->SetElement(
      n / 4, n % 4, values->GetComponent(n / values->GetNumberOfComponents(), n % values->GetNumberOfComponents()));
  }
}

/// A point mapped by a matrix whose last row is (0, 0, 0, 1).
std::array<double, 3> Map(vtkMatrix4x4* matrix, const double point[3])
{
  const double from[4] = { point[0], point[1], point[2], 1.0 };
  double to[4];
  matrix->MultiplyPoint(from, to);
  return { to[0], to[1], to[2] };
}
}

vtkStandardNewMacro(vtkHorizonSmoothing);

//------------------------------------------------------------------------------
void vtkHorizonSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
}

//------------------------------------------------------------------------------
void vtkHorizonSmoothing::ProcessPolyData(
  vtkPolyData* input, const std::vector<vtkPolyData*>& outputs, const SeismicHorizons::Monitor& monitor)
{
  vtkNew<vtkMatrix4x4> toWorld;
  ReadMap(input, toWorld);
  vtkNew<vtkMatrix4x4> toLattice;
  vtkMatrix4x4::Invert(toWorld, toLattice);

  const vtkIdType size = input->GetNumberOfPoints();
  std::vector<std::array<int, 2>> columns(size);
  std::vector<double> heights(size);
  for (vtkIdType id = 0; id < size; ++id)
  {
    const std::array<double, 3> place = Map(toLattice, input->GetPoint(id));
    columns[id] = { int(std::lround(place[0])), int(std::lround(place[1])) };
    heights[id] = place[2];
  }

  const std::vector<double> smooth = SmoothHeights(columns, heights, this->Radius, monitor);

  // Points, cells and arrays are those of the input, but for the heights.
  vtkPolyData* const output = outputs.front();
  output->ShallowCopy(input);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(size);
  for (vtkIdType id = 0; id < size; ++id)
  {
    const double place[3] = { double(columns[id][0]), double(columns[id][1]), smooth[id] };
    points->SetPoint(id, Map(toWorld, place).data());
  }
  output->SetPoints(points);
}
