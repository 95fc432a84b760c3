// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurfaceJoin.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/PipelineRequest.h"
#include "Filters/Algorithms/Surface/SurfaceJoin.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "SeamData.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// Parts must agree in parameters that affect seams.
void RequireSame(vtkPolyData* first, vtkPolyData* other, const char* name)
{
  vtkDataArray* const expected = first->GetFieldData()->GetArray(name);
  vtkDataArray* const found = other->GetFieldData()->GetArray(name);
  const vtkIdType size = expected ? expected->GetNumberOfValues() : 0;
  for (vtkIdType n = 0; n < size; ++n)
  {
    if (!found || found->GetNumberOfValues() != size || FieldValue(found, int(n)) != FieldValue(expected, int(n)))
    {
      std::ostringstream text;
      text << "parts that differ in " << name << " (" << (found ? std::to_string(FieldValue(found, int(n))) : "none")
           << " and " << FieldValue(expected, int(n)) << "), expected parts of one horizon with the same parameters";
      throw InputError(text.str());
    }
  }
}

/// Parts with points, in ascending order of rows.
std::vector<vtkPolyData*> ListParts(vtkInformationVector* inputs)
{
  std::vector<std::pair<double, vtkPolyData*>> parts;
  for (int n = 0; n < inputs->GetNumberOfInformationObjects(); ++n)
  {
    vtkPolyData* const mesh = vtkPolyData::GetData(inputs, n);
    if (mesh && (mesh->GetNumberOfPoints() > 0 || mesh->GetFieldData()->GetArray(FieldArray::SeamRows)))
    {
      parts.push_back({ FirstValue(mesh->GetFieldData(), FieldArray::SeamRows), mesh });
    }
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<vtkPolyData*> meshes;
  std::transform(parts.begin(), parts.end(), std::back_inserter(meshes), [](const auto& part) { return part.second; });
  return meshes;
}
}

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
      CheckAtLeast("minimum patch size", this->MinimumPatchSize, 1, " point");
      const std::vector<vtkPolyData*> meshes = ListParts(inputVector[0]);
      std::vector<SurfacePart> parts;
      for (vtkPolyData* const mesh : meshes)
      {
        for (const char* const name : { FieldArray::LatticeToWorld, FieldArray::ChosenRadius,
               FieldArray::ChosenSmallestHoleSize, FieldArray::ChosenDistanceThreshold })
        {
          RequireSame(meshes.front(), mesh, name);
        }
        parts.push_back(ReadSurfacePart(mesh));
        monitor.Progress(0.4 * double(parts.size()) / double(meshes.size()));
      }
      if (!parts.empty())
      {
        const JoinedSurface joined = JoinSurface(parts, this->MinimumPatchSize);
        monitor.Progress(0.8);
        WriteJoinedSurface(meshes, ReadLattice(meshes.front()), joined, output);
      }
    });
}
