// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonAlgorithm.h"

#include "DataModel.h"
#include "Errors.h"
#include "ProgressMonitor.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
using HorizonPairs = std::vector<std::pair<vtkPolyData*, vtkSmartPointer<vtkPolyData>>>;

constexpr const char* NoMemory = "not enough memory, expected a horizon whose bounding box has fewer columns";

/// Every horizon of the input with an empty one for it, which is put at the same place of the output.
HorizonPairs MakePairs(vtkDataObject* input, vtkDataObject* output)
{
  HorizonPairs pairs;
  if (vtkPolyData* const horizon = vtkPolyData::SafeDownCast(input))
  {
    pairs.emplace_back(horizon, vtkPolyData::SafeDownCast(output));
    return pairs;
  }
  vtkDataObjectTree* const tree = vtkDataObjectTree::SafeDownCast(input);
  vtkDataObjectTree* const result = vtkDataObjectTree::SafeDownCast(output);
  result->CopyStructure(tree);
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  iterator->SkipEmptyNodesOn();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* const leaf = iterator->GetCurrentDataObject();
    vtkPolyData* const horizon = vtkPolyData::SafeDownCast(leaf);
    if (!horizon)
    {
      throw SeismicHorizons::InputError(
        std::string("a ") + leaf->GetClassName() + " in the composite dataset, expected only vtkPolyData");
    }
    auto empty = vtkSmartPointer<vtkPolyData>::New();
    result->SetDataSet(iterator, empty);
    pairs.emplace_back(horizon, empty);
  }
  return pairs;
}

/// How messages call a horizon: by the surface ID of its points, when they have one.
std::string Name(vtkPolyData* horizon)
{
  vtkDataArray* const ids = horizon->GetPointData()->GetArray(SeismicHorizons::PointArray::SurfaceId);
  return ids && ids->GetNumberOfTuples() > 0
    ? "Horizon " + std::to_string(static_cast<long long>(ids->GetComponent(0, 0))) + ": "
    : std::string();
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
  vtkDataObject* const output = vtkDataObject::GetData(outputVector, 0);
  if (input && (!output || !output->IsA(input->GetClassName())))
  {
    auto fresh = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHorizonAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  vtkDataObject* const output = vtkDataObject::GetData(outputVector, 0);
  const SeismicHorizons::Monitor monitor = SeismicHorizons::MakeMonitor(this);
  std::string name;
  std::string problem;
  try
  {
    const HorizonPairs pairs = MakePairs(input, output);
    for (std::size_t n = 0; n < pairs.size(); ++n)
    {
      vtkPolyData* const horizon = pairs[n].first;
      name = Name(horizon);
      pairs[n].second->GetFieldData()->PassData(horizon->GetFieldData());
      if (horizon->GetNumberOfPoints() > 0)
      {
        const double size = double(pairs.size());
        this->ProcessHorizon(horizon, pairs[n].second, monitor.Step(double(n) / size, double(n + 1) / size));
      }
    }
    output->GetFieldData()->PassData(input->GetFieldData());
    return 1;
  }
  catch (const SeismicHorizons::Aborted&)
  {
    output->Initialize();
    return 1;
  }
  catch (const SeismicHorizons::InputError& error)
  {
    problem = error.what();
  }
  catch (const std::bad_alloc&)
  {
    problem = NoMemory;
  }
  catch (const std::length_error&) // more than any memory could hold
  {
    problem = NoMemory;
  }
  output->Initialize();
  vtkErrorMacro(<< name << problem);
  return 0;
}
