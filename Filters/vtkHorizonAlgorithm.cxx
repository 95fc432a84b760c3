// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "Common/Errors.h"
#include "Common/Monitor.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Marshalling/HorizonTree.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

using namespace SeismicHorizons;

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
int vtkHorizonAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  AcceptHorizons(info);
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
  return RunRequest(this, outputs, NotEnoughMemory,
    [this, input, &outputs](std::string& subject, const Monitor& monitor)
    {
      const std::vector<HorizonLeaf> horizons = ListHorizons(input, outputs);
      const double size = double(horizons.size());
      for (std::size_t n = 0; n < horizons.size(); ++n)
      {
        const HorizonLeaf& horizon = horizons[n];
        subject = NameBySurfaceId(horizon.Input);
        if (horizon.Input->GetNumberOfPoints() > 0)
        {
          this->ProcessHorizon(horizon.Input, horizon.Outputs, monitor.Step(double(n) / size, double(n + 1) / size));
        }
      }
    });
}
