// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonThickness.h"

#include "Common/Base/Errors.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "Common/VTK/ImageConversion.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/RankedHorizons.h"
#include "Common/VTK/Ranks.h"
#include "ThicknessStage.h"

#include "vtkAbstractArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int OtherPort = 1; // input port
constexpr int MapPort = 1; // output port

/// Skips empty horizons and the horizon itself.
vtkPolyData* FindOther(const std::vector<vtkSmartPointer<vtkPolyData>>& others, const Horizon& horizon)
{
  const vtkSmartPointer<vtkAbstractArray> places = ToVTK(horizon.Places); // the array they came from
  std::vector<vtkPolyData*> found;
  for (vtkPolyData* const other : others)
  {
    if (other->GetNumberOfPoints() > 0 && other->GetPoints()->GetData() != places)
    {
      found.push_back(other);
    }
  }
  if (found.size() != 1)
  {
    throw InputError(std::to_string(found.size()) +
      " other horizons with points, expected one as the input Other Horizon, for instance by Extract Block");
  }
  return found.front();
}
}

vtkStandardNewMacro(vtkHorizonThickness);

//------------------------------------------------------------------------------
vtkHorizonThickness::vtkHorizonThickness()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkImageData* vtkHorizonThickness::GetMap()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(MapPort));
}

//------------------------------------------------------------------------------
int vtkHorizonThickness::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonThickness::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  AskForWhole(inputVector[0], 1);
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
// Two horizons can be selected at once in ParaView, which connects both to the first input.
vtkDataObject* vtkHorizonThickness::GetOther()
{
  const int others = this->GetNumberOfInputConnections(0) - 1 + this->GetNumberOfInputConnections(OtherPort);
  if (others > 1)
  {
    throw InputError(std::to_string(others + 1) + " inputs, expected two horizons, or one input that has both");
  }
  return this->GetNumberOfInputConnections(0) > 1 ? this->GetInputDataObject(0, 1)
                                                  : this->GetInputDataObject(OtherPort, 0);
}

//------------------------------------------------------------------------------
int vtkHorizonThickness::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  MakeOutputLike<vtkImageData>(vtkDataObject::GetData(inputVector[0], 0), outputVector->GetInformationObject(MapPort));
  return this->Superclass::RequestDataObject(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
// Without the input Other, the two horizons of the first input, which may be on different ranks, are a pair.
void vtkHorizonThickness::ShareHorizons(
  const std::vector<HorizonLeaf>& own, const std::vector<RankedHorizon>& all, const Ranks& ranks)
{
  this->Others.clear();
  vtkDataObject* const given = this->GetOther();
  if (given || ranks.Size() == 1)
  {
    for (const HorizonLeaf& leaf : given ? ListHorizons(given, {}) : own)
    {
      this->Others.push_back(leaf.Input);
    }
    return;
  }
  std::vector<RankedHorizon> shared;
  std::copy_if(all.begin(), all.end(), std::back_inserter(shared),
    [](const RankedHorizon& horizon) { return horizon.Points > 0; });
  if (shared.size() > 2)
  {
    ranks.Refuse(std::to_string(shared.size()) + " horizons with points, expected two, or one as the input Other Horizon");
  }
  this->Others = ShareOnRanks(shared, own, ranks);
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  this->Warn(RunThickness(horizon, FromVTK(FindOther(this->Others, horizon)), outputs, monitor));
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessOutputs(const std::vector<vtkDataObject*>& outputs)
{
  this->Others.clear();
  const auto make = [this](vtkDataObject* points, vtkImageData* map)
  {
    RunPart(this, true, "the map", { map },
      [&]() { ToVTK(MakeThicknessMap(FromVTK(vtkPolyData::SafeDownCast(points))), map); });
  };
  auto* const tree = vtkDataObjectTree::SafeDownCast(outputs.front());
  if (!tree)
  {
    make(outputs.front(), vtkImageData::SafeDownCast(outputs[MapPort]));
    return;
  }
  auto* const maps = vtkDataObjectTree::SafeDownCast(outputs[MapPort]);
  maps->CopyStructure(tree);
  auto place = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem())
  {
    vtkNew<vtkImageData> map;
    make(place->GetCurrentDataObject(), map);
    maps->SetDataSet(place, map);
  }
}
