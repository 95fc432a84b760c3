// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "Common/Errors.h"
#include "Common/Monitor.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace
{
struct Horizon
{
  vtkPolyData* Input;
  std::vector<vtkPolyData*> Outputs; // by port
};

/// Every horizon of a composite input with an empty one for it at the same place of each output.
std::vector<Horizon> MakeHorizons(vtkDataObjectTree* input, const std::vector<vtkDataObject*>& outputs)
{
  std::vector<Horizon> horizons;
  for (vtkDataObject* output : outputs)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(input);
  }
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(input->NewTreeIterator());
  iterator->SkipEmptyNodesOn();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* const leaf = iterator->GetCurrentDataObject();
    horizons.push_back({ vtkPolyData::SafeDownCast(leaf), {} });
    if (!horizons.back().Input)
    {
      throw SeismicHorizons::InputError(
        std::string("a ") + leaf->GetClassName() + " in the composite dataset, expected only vtkPolyData");
    }
    for (vtkDataObject* output : outputs)
    {
      vtkNew<vtkPolyData> empty;
      vtkDataObjectTree::SafeDownCast(output)->SetDataSet(iterator, empty);
      horizons.back().Outputs.push_back(empty);
    }
  }
  return horizons;
}

std::vector<Horizon> MakeHorizons(vtkDataObject* input, const std::vector<vtkDataObject*>& outputs)
{
  if (vtkDataObjectTree* const tree = vtkDataObjectTree::SafeDownCast(input))
  {
    return MakeHorizons(tree, outputs);
  }
  Horizon horizon{ vtkPolyData::SafeDownCast(input), {} };
  for (vtkDataObject* output : outputs)
  {
    horizon.Outputs.push_back(vtkPolyData::SafeDownCast(output));
  }
  return { horizon };
}
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHorizonAlgorithm::GetPolyDataOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessHorizonPorts(
  vtkPolyData* input, const Outputs& outputs, const SeismicHorizons::Monitor& monitor)
{
  this->ProcessHorizon(input, outputs.front(), monitor);
}

//------------------------------------------------------------------------------
void vtkHorizonAlgorithm::ProcessHorizon(vtkPolyData*, vtkPolyData*, const SeismicHorizons::Monitor&) {}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  for (int port = 0; input && port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* const output = vtkDataObject::GetData(outputVector, port);
    if (!output || !output->IsA(input->GetClassName()))
    {
      auto fresh = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), fresh);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  std::vector<vtkDataObject*> outputs;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(vtkDataObject::GetData(outputVector, port));
  }
  return this->Run(outputs,
    [this, input, &outputs](std::string& subject, const SeismicHorizons::Monitor& monitor)
    {
      const std::vector<Horizon> horizons = MakeHorizons(input, outputs);
      for (std::size_t n = 0; n < horizons.size(); ++n)
      {
        const Horizon& horizon = horizons[n];
        subject = SeismicHorizons::NameBySurfaceId(horizon.Input);
        for (vtkPolyData* output : horizon.Outputs)
        {
          output->GetFieldData()->PassData(horizon.Input->GetFieldData());
        }
        if (horizon.Input->GetNumberOfPoints() > 0)
        {
          const double size = double(horizons.size());
          this->ProcessHorizonPorts(
            horizon.Input, horizon.Outputs, monitor.Step(double(n) / size, double(n + 1) / size));
        }
      }
      for (vtkDataObject* output : outputs)
      {
        output->GetFieldData()->PassData(input->GetFieldData());
      }
    });
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::Run(const std::vector<vtkDataObject*>& outputs, const Work& work)
{
  return SeismicHorizons::RunRequest(
    this, outputs, "not enough memory, expected a horizon whose bounding box has fewer columns", work);
}
