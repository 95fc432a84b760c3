// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/VersionDifferences.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "Filters/Marshalling/LedgerOutput.h"
#include "Filters/Marshalling/PlacedPoints.h"
#include "Filters/Marshalling/RankedHorizons.h"
#include "Filters/Marshalling/StageReport.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

using namespace SeismicHorizons;

//------------------------------------------------------------------------------
vtkPolyData* vtkHorizonAlgorithm::GetPolyDataOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessOutputs(const std::vector<vtkDataObject*>&) {}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ShareHorizons(
  const std::vector<HorizonLeaf>&, const std::vector<RankedHorizon>&, const Ranks&)
{
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::Warn(const std::string& text)
{
  vtkWarningMacro(<< this->HorizonName << (this->HorizonName.empty() ? "" : ": ") << text);
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 1; port < this->GetNumberOfInputPorts(); ++port)
  {
    AskForWhole(inputVector[port]);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfHorizonPorts(); ++port)
  {
    MakeOutputLike(vtkDataObject::GetData(inputVector[0], 0), outputVector->GetInformationObject(port));
  }
  return 1;
}

//------------------------------------------------------------------------------
// vtkCompositeDataPipeline would loop over leaves, but it continues after errors and aborts, keeps partial output, and
// does not join the partitions of a horizon.
int vtkHorizonAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  const std::vector<vtkDataObject*> outputs = ListOutputs(outputVector);
  const Ranks ranks(this->GetController(), request, outputVector);
  StageReport report;
  const auto work = [this, input, &outputs, &ranks, &report](std::string& subject, const Monitor& monitor)
  {
    std::vector<HorizonLeaf> horizons;
    const auto end = outputs.begin() + this->GetNumberOfHorizonPorts();
    ranks.Together([&]() { horizons = ListHorizons(input, { outputs.begin(), end }); });
    // This throws if several ranks have points of a horizon.
    this->ShareHorizons(horizons, ListOnRanks(horizons, ranks), ranks);
    ranks.Together(
      [&]()
      {
        const double size = double(horizons.size());
        for (std::size_t n = 0; n < horizons.size(); ++n)
        {
          const HorizonLeaf& horizon = horizons[n];
          subject = this->HorizonName = horizon.Name;
          if (horizon.Input->GetNumberOfPoints() > 0)
          {
            const Monitor step = monitor.Step(double(n) / size, double(n + 1) / size);
            RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject,
              { horizon.Outputs.begin(), horizon.Outputs.end() },
              [&]()
              {
                CheckArraySizes(horizon.Input);
                if (IsMesh(horizon.Input) && !this->TakesMeshes())
                {
                  throw InputError("a mesh of " +
                    std::to_string(horizon.Input->GetNumberOfPolys() + horizon.Input->GetNumberOfStrips()) +
                    " triangles, expected the points of a horizon, as they are before it is meshed");
                }
                if (CountVisiblePoints(horizon.Input) == 0)
                {
                  this->Warn("all " + std::to_string(horizon.Input->GetNumberOfPoints()) +
                    " points are hidden by the array vtkGhostType, so that nothing is left");
                  return;
                }
                this->ProcessHorizon(horizon.Input, horizon.Outputs, step);
                WriteLedgerOfPoints(horizon.Input, horizon.Outputs.front());
              });
            report.Add(horizon.Position, horizon.Name, horizon.Input, horizon.Outputs.front());
          }
        }
        subject.clear();
        this->ProcessOutputs(outputs);
      });
    report.Join(ranks);
  };
  this->Results.clear();
  const int done = RunRequest(this, outputs, NotEnoughMemory, work, ranks);
  this->Results = IsAborted(this) ? "stopped before the end: nothing was made\n" : done ? report.Text() : std::string();
  this->Results = done && this->Results.empty() ? "no points in the input: nothing was made\n" : this->Results;
  return done;
}
