// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRepresentation.h"

#include "VerticalAxis.h"

#include "Common/Horizon/DataModel.h"

#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cmath>

class vtkHorizonHeights : public vtkPassInputTypeAlgorithm
{
public:
  static vtkHorizonHeights* New();
  vtkTypeMacro(vtkHorizonHeights, vtkPassInputTypeAlgorithm);

protected:
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

vtkStandardNewMacro(vtkHorizonHeights);
vtkStandardNewMacro(vtkHorizonRepresentation);

namespace
{
using namespace SeismicHorizons;

void AddHeights(vtkPointSet* points)
{
  const VerticalAxis axis = ReadVerticalAxis(points->GetFieldData());
  if (axis.Name.empty() || points->GetPointData()->HasArray(axis.Name.c_str()))
  {
    return;
  }
  vtkNew<vtkFloatArray> heights;
  heights->SetName(axis.Name.c_str());
  heights->SetNumberOfValues(points->GetNumberOfPoints());
  const float sign = axis.IsDownwards ? -1.0f : 1.0f;
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    heights->SetValue(n, sign * static_cast<float>(points->GetPoint(n)[2]));
  }
  points->GetPointData()->AddArray(heights);
}

/// Simplified outlines need another name, since colours depend on names.
void AddSimplifiedBoundary(vtkPointSet* points)
{
  vtkDataArray* const boundary = points->GetPointData()->GetArray(PointArray::Boundary);
  if (boundary && points->GetFieldData()->HasArray(FieldArray::OutlineDeviation))
  {
    const auto renamed = vtk::TakeSmartPointer(boundary->NewInstance());
    renamed->ShallowCopy(boundary);
    renamed->SetName("Simplified Boundary");
    points->GetPointData()->AddArray(renamed);
  }
}

/// Moves fault lines from mid throw to the upper edge, where the horizon does not hide them.
void LiftFaultLines(vtkPointSet* points)
{
  vtkDataArray* const throws = points->GetPointData()->GetArray(PointArray::Throw);
  vtkDataArray* const toWorld = points->GetFieldData()->GetArray(FieldArray::LatticeToWorld);
  if (!throws || !toWorld || toWorld->GetNumberOfValues() != 16)
  {
    return;
  }
  const double half = std::fabs(toWorld->GetComponent(0, 10)) / 2.0; // Half a vertical index.
  vtkNew<vtkPoints> lifted;
  lifted->DeepCopy(points->GetPoints());
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
  {
    double* const place = lifted->GetPoint(n);
    const double lift = half * std::fabs(throws->GetComponent(n, 0));
    lifted->SetPoint(n, place[0], place[1], place[2] + (std::isfinite(lift) ? lift : 0.0));
  }
  points->SetPoints(lifted);
}

void AddArrays(vtkDataObject* block)
{
  auto* const points = vtkPointSet::SafeDownCast(block);
  if (points && points->GetPoints())
  {
    AddHeights(points);
    AddSimplifiedBoundary(points);
    LiftFaultLines(points);
  }
}

int CallBase(vtkClientServerInterpreter* interpreter, vtkObjectBase* object, const char* method,
  const vtkClientServerStream& message, vtkClientServerStream& result, void*)
{
  return interpreter->CallCommandFunction("vtkPVCompositeRepresentation", object, method, message, result);
}
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonHeights::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* const output = vtkDataObject::GetData(outputs);
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(output);
  if (!blocks)
  {
    output->ShallowCopy(input);
    AddArrays(output);
    return 1;
  }
  blocks->ShallowCopy(input);
  const auto blocksToDo = vtk::TakeSmartPointer(blocks->NewIterator());
  for (blocksToDo->InitTraversal(); !blocksToDo->IsDoneWithTraversal(); blocksToDo->GoToNextItem())
  {
    AddArrays(blocksToDo->GetCurrentDataObject());
  }
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonRepresentation::vtkHorizonRepresentation()
  : Heights(vtkSmartPointer<vtkHorizonHeights>::New())
{
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonRepresentation::~vtkHorizonRepresentation() = default;

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonRepresentation::Register()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(
    [](vtkClientServerInterpreter* interpreter)
    {
      interpreter->AddNewInstanceFunction(
        "vtkHorizonRepresentation", [](void*) -> vtkObjectBase* { return vtkHorizonRepresentation::New(); });
      interpreter->AddCommandFunction("vtkHorizonRepresentation", CallBase);
    });
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  this->InsertHeights();
  return this->Superclass::ProcessViewRequest(request, input, output);
}

//----------------------------------------------------------------------------------------------------------------------
vtkDataObject* vtkHorizonRepresentation::GetRenderedDataObject(int port)
{
  if (!this->InsertHeights())
  {
    return this->Superclass::GetRenderedDataObject(port);
  }
  if (this->Heights->GetOutputDataObject(0)->GetUpdateTime() == 0)
  {
    // ParaView requests the range of the colour array before the first rendering.
    vtkMultiProcessController* const ranks = vtkMultiProcessController::GetGlobalController();
    this->Heights->UpdatePiece(ranks ? ranks->GetLocalProcessId() : 0, ranks ? ranks->GetNumberOfProcesses() : 1, 0);
  }
  return this->Heights->GetOutputDataObject(0);
}

//----------------------------------------------------------------------------------------------------------------------
bool vtkHorizonRepresentation::InsertHeights()
{
  vtkPVDataRepresentation* const drawing = this->GetActiveRepresentation();
  if (!drawing || drawing->GetNumberOfInputConnections(0) == 0)
  {
    return false;
  }
  // ParaView may reconnect the mapper to the pipeline.
  if (drawing->GetInputConnection(0, 0) != this->Heights->GetOutputPort())
  {
    this->Heights->SetInputConnection(drawing->GetInputConnection(0, 0));
    drawing->SetInputConnection(this->Heights->GetOutputPort());
  }
  return true;
}
