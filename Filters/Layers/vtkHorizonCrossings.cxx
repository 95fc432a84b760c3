// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCrossings.h"

#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "StackCrossings.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <string>
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
      const CrossingStageResult result = RunCrossings(stack, this->MakeStackOptions(), monitor);
      for (std::size_t horizon = 0; horizon < stack.Size(); ++horizon)
      {
        ToVTK(result.Horizons[horizon], BlockOf(outputs.front(), horizon));
      }
      this->Results = result.Report;
    };
    ranks.Together(repair);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}
