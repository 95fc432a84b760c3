// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StackOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Filters/Marshalling/HorizonPoints.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <sstream>
#include <vector>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void WriteRepaired(
  const RepairedHorizons& repaired, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output)
{
  const StackedHorizon& given = stack[horizon];
  const std::vector<double>& heights = repaired.Heights[horizon];
  output->ShallowCopy(given.Points.Horizon);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vtkIdType(heights.size()));
  std::vector<double> moved(heights.size());
  std::vector<double> indices(heights.size());
  for (std::size_t point = 0; point < heights.size(); ++point)
  {
    const auto number = vtkIdType(point);
    Eigen::Vector3d world(given.Points.Horizon->GetPoint(number));
    moved[point] = heights[point] - world.z();
    world.z() = heights[point];
    points->SetPoint(number, world.data());
    indices[point] = given.Points.Lattice.ToLattice(world).z();
  }
  output->SetPoints(points);
  vtkPointData* const data = output->GetPointData();
  data->RemoveArray(PointArray::RealZ);
  AddArray<vtkDoubleArray>(data, PointArray::VerticalIndex, indices);
  AddArray<vtkDoubleArray>(data, PointArray::Moved, moved);
  ActivateHeight(output);
  const MovedHorizon& own = repaired.Repair.Horizons[horizon];
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::MovedColumns, vtkIdType(own.Columns));
  AddValue<vtkDoubleArray>(figures, FieldArray::FarthestMove, own.Farthest);
}

//----------------------------------------------------------------------------------------------------------------------
std::string TellRepair(const CrossingRepair& repair, const HorizonStack& stack)
{
  std::ostringstream text;
  for (std::size_t n = 0; n < repair.Interfaces.size(); ++n)
  {
    const CrossedInterface& crossed = repair.Interfaces[n];
    text << stack[n].Name << " and " << stack[n + 1].Name << "\n  crossed in " << crossed.Columns << " columns";
    if (crossed.Columns > 0)
    {
      text << ", by up to " << crossed.Deepest;
    }
    text << '\n';
  }
  for (std::size_t n = 0; n < repair.Horizons.size(); ++n)
  {
    const MovedHorizon& moved = repair.Horizons[n];
    text << stack[n].Name << ": " << moved.Columns << " of " << stack[n].Placed.Columns.size() << " points moved";
    if (moved.Columns > 0)
    {
      text << ", by up to " << moved.Farthest;
    }
    text << '\n';
  }
  return text.str();
}
}
