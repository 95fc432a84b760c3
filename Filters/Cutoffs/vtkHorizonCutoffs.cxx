// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCutoffs.h"

#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "CutoffOutput.h"
#include "CutoffStage.h"
#include "FaultInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
enum OutputPort : std::size_t
{
  CutoffsOutput,
  PolygonsOutput,
  PlatesOutput,
  JuxtapositionOutput,
  DiagramsOutput,
  FiguresOutput,
  AreasOutput
};

void WriteOutputs(const CutoffStageResult& result, const std::vector<vtkDataObject*>& outputs)
{
  const auto writeBlocks = [&outputs](const std::vector<Horizon>& blocks, OutputPort port)
  {
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      ToVTK(blocks[n], BlockOf(outputs[port], n));
    }
  };
  writeBlocks(result.Cutoffs, CutoffsOutput);
  writeBlocks(result.Polygons, PolygonsOutput);
  ToVTK(result.Juxtaposition, vtkPolyData::SafeDownCast(outputs[JuxtapositionOutput]));
  ToVTK(result.Diagrams, vtkPolyData::SafeDownCast(outputs[DiagramsOutput]));
  ToVTK(result.Faults, vtkPolyData::SafeDownCast(outputs[PlatesOutput]));
  ToVTK(result.Figures, vtkTable::SafeDownCast(outputs[FiguresOutput]));
  ToVTK(result.Areas, vtkTable::SafeDownCast(outputs[AreasOutput]));
}
}

vtkStandardNewMacro(vtkHorizonCutoffs);

//------------------------------------------------------------------------------
vtkHorizonCutoffs::vtkHorizonCutoffs()
{
  this->SetNumberOfOutputPorts(7);
}

//------------------------------------------------------------------------------
vtkHorizonCutoffs::~vtkHorizonCutoffs() = default;

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char *const blocks = "vtkPartitionedDataSetCollection", *const surface = "vtkPolyData";
  const std::array<const char*, 7> types = { blocks, blocks, surface, surface, surface, "vtkTable", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[std::size_t(port)]);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonCutoffs::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  this->Results.clear();
  const auto work = [&](std::string& subject, const Monitor& monitor)
  {
    const auto find = [&]()
    {
      const CutInputs inputs = this->ReadInputs(inputVector, subject);
      std::vector<std::string> names;
      for (const CutInput& horizon : inputs.Horizons)
      {
        names.push_back(horizon.Name);
      }
      MakeBlocks(names, "Cutoffs", outputs[CutoffsOutput]);
      MakeBlocks(names, "Polygons", outputs[PolygonsOutput]);
      if (ranks.Own() > 0)
      {
        return;
      }
      CutoffStageOptions options = this->MakeCutOptions();
      options.LargestGap = this->LargestGap;
      options.SmallestLength = this->SmallestLength;
      const CutoffModelData model = RunCutoffs(inputs.Horizons, inputs.Faults.Picks, options, monitor.Step(0.0, 0.9));
      monitor.Progress(0.9);
      const CutoffStageResult result = WriteCutoffs(model, inputs.Fields);
      WriteOutputs(result, outputs);
      this->Results = result.Report;
      for (const std::vector<std::string>& warnings : { inputs.Faults.Warnings, model.Warnings })
      {
        for (const std::string& warning : warnings)
        {
          vtkWarningMacro(<< warning);
        }
      }
    };
    ranks.Together(find);
  };
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = done && !IsAborted(this) ? this->Results : std::string();
  return done;
}
