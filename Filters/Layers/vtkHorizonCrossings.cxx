// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCrossings.h"

#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Algorithms/Layers/OrderedStack.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "HorizonStack.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace SeismicHorizons
{
namespace
{
/// Repaired heights are world z.
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
  const RepairFigures& own = repaired.Repair.Horizons[horizon];
  vtkFieldData* const figures = output->GetFieldData();
  AddValue<vtkIdTypeArray>(figures, FieldArray::MovedColumns, vtkIdType(own.Columns));
  AddValue<vtkDoubleArray>(figures, FieldArray::FarthestMove, own.Largest);
}

/// Lists crossings of neighbours, and moved horizons.
std::string ReportRepair(const CrossingRepair& repair, const HorizonStack& stack)
{
  std::ostringstream text;
  for (std::size_t n = 0; n < repair.Interfaces.size(); ++n)
  {
    const RepairFigures& crossed = repair.Interfaces[n];
    text << stack[n].Name << " and " << stack[n + 1].Name << "\n  crossed in " << crossed.Columns << " columns";
    if (crossed.Columns > 0)
    {
      text << ", by up to " << crossed.Largest;
    }
    text << '\n';
  }
  for (std::size_t n = 0; n < repair.Horizons.size(); ++n)
  {
    const RepairFigures& moved = repair.Horizons[n];
    text << stack[n].Name << ": " << moved.Columns << " of " << stack[n].Placed.Columns.size() << " points moved";
    if (moved.Columns > 0)
    {
      text << ", by up to " << moved.Largest;
    }
    text << '\n';
  }
  return text.str();
}
}
}

vtkStandardNewMacro(vtkHorizonCrossings);

//------------------------------------------------------------------------------
int vtkHorizonCrossings::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
  return 1;
}

//------------------------------------------------------------------------------
// Repair works on the given z, so that merged horizons get equal values and unmoved points keep their z exactly.
RepairedHorizons vtkHorizonCrossings::Repair(const HorizonStack& stack, const Monitor& monitor)
{
  const HeightStack heights = stack.WorldHeights();
  std::vector<HorizonView> views = stack.Views();
  for (std::size_t n = 0; n < views.size(); ++n)
  {
    views[n].Heights = heights[n].data();
  }
  const std::string& unit = stack.GetSurvey().VerticalUnit;
  CrossingOptions options = this->MakeCrossings(stack);
  options.HeightsGrowDownwards = false;
  options.Unit = unit.empty() ? "in z" : unit;
  options.MinimumThickness =
    this->GetMinimumThickness() * (this->GetHeightUnit() == World ? 1.0 : WorldPerIndex(stack.CommonLattice()));
  return RepairHorizons(views, options, monitor);
}

//------------------------------------------------------------------------------
int vtkHorizonCrossings::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  this->Results.clear();
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    const auto repair = [&]()
    {
      const HorizonStack stack = this->ReadStack(inputVector[0], subject, monitor.Step(0.0, 0.4));
      monitor.Progress(0.4);
      MakeBlocks(stack.Names(), "Horizons", outputs.front());
      if (ranks.Own() > 0)
      {
        return;
      }
      const RepairedHorizons repaired = this->Repair(stack, monitor.Step(0.4, 0.8));
      for (std::size_t horizon = 0; horizon < stack.Size(); ++horizon)
      {
        WriteRepaired(repaired, horizon, stack, BlockOf(outputs.front(), horizon));
        monitor.Progress(0.8 + 0.15 * double(horizon + 1) / double(stack.Size()));
      }
      this->Results = ReportRepair(repaired.Repair, stack);
    };
    ranks.Together(repair);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}
