// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurfaceJoin.h"

#include "Common/Base/Monitor.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/PipelineRequest.h"
#include "SurfaceStage.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonSurfaceJoin);

//------------------------------------------------------------------------------
int vtkHorizonSurfaceJoin::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonSurfaceJoin::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  return RunRequest(this, { output }, NotEnoughMemory,
    [&](std::string&, const Monitor& monitor)
    {
      std::vector<Horizon> meshes;
      for (int n = 0; n < inputVector[0]->GetNumberOfInformationObjects(); ++n)
      {
        if (vtkPolyData* const mesh = vtkPolyData::GetData(inputVector[0], n))
        {
          meshes.push_back(FromVTK(mesh));
        }
      }
      Horizon joined;
      RunSurfaceJoin(std::move(meshes), this->MinimumPatchSize, joined, monitor);
      ToVTK(joined, output);
    });
}
