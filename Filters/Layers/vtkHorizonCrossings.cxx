// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCrossings.h"

#include "Common/Base/Monitor.h"
#include "Common/VTK/NamedCollection.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Algorithms/Layers/OrderedStack.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "HorizonStack.h"
#include "StackOutput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vector>

using namespace SeismicHorizons;

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
      this->Results = TellRepair(repaired.Repair, stack);
    };
    ranks.Together(repair);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}
