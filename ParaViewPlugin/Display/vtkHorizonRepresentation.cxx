// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonRepresentation.h"

#include "ContourShader.h"
#include "HorizonSheet.h"
#include "ShownAxis.h"

#include "Common/Horizon/DataModel.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkClientServerStream.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGeometryRepresentation.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVView.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <cstring>
#include <string>

class vtkHorizonHeights : public vtkPassInputTypeAlgorithm
{
public:
  static vtkHorizonHeights* New();
  vtkTypeMacro(vtkHorizonHeights, vtkPassInputTypeAlgorithm);

  vtkSetMacro(ContourInterval, double);
  vtkSetMacro(DrawsSurfaces, bool);
  vtkGetMacro(DrawsSurfaces, bool);

  /// Makes the sheets of drawn data coarser. Returns null if there are other data, too.
  vtkSmartPointer<vtkDataObject> Thin(vtkDataObject* drawn) const;

protected:
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double ContourInterval = 0.0;
  bool DrawsSurfaces = false;
};

vtkStandardNewMacro(vtkHorizonHeights);
vtkStandardNewMacro(vtkHorizonRepresentation);

namespace
{
using namespace SeismicHorizons;

/// Colours and legends depend on names.
void AddRenamed(vtkAbstractArray* array, const char* name, vtkFieldData* arrays)
{
  if (array)
  {
    const auto renamed = vtk::TakeSmartPointer(array->NewInstance());
    renamed->DeepCopy(array);
    renamed->SetName(name);
    arrays->AddArray(renamed);
  }
}

void AddRenamedArrays(vtkPointSet* points)
{
  if (points->GetFieldData()->HasArray(FieldArray::OutlineDeviation))
  {
    AddRenamed(points->GetPointData()->GetArray(PointArray::Boundary), "Simplified Boundary", points->GetPointData());
  }
  vtkCellData* const cells = points->GetCellData();
  if (points->GetPointData()->HasArray(PointArray::Heave)) // Cutoffs.
  {
    AddRenamed(cells->GetAbstractArray(CellArray::FaultStick), "Wall", cells);
  }
  AddRenamed(cells->GetAbstractArray(CellArray::IndexContour), "Contours", cells);
}

/// Adds thickness and throw in the unit of z.
void AddHeightsInUnit(vtkDataSet* data, const VerticalAxis& axis)
{
  for (const char* const name : { PointArray::Isochore, PointArray::Isopach, PointArray::Moved, PointArray::Throw })
  {
    vtkDataArray* const array = data->GetPointData()->GetArray(name);
    const ShownArray shown = ShowInUnit(name, axis);
    if (array && !data->GetPointData()->HasArray(shown.Name.c_str()) && array->GetNumberOfComponents() == 1)
    {
      vtkNew<vtkDoubleArray> inUnit;
      inUnit->SetName(shown.Name.c_str());
      inUnit->SetNumberOfValues(array->GetNumberOfTuples());
      for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
      {
        inUnit->SetValue(n, shown.Factor * array->GetComponent(n, 0));
      }
      data->GetPointData()->AddArray(inUnit);
    }
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

/// Gives access to a switch that ParaView's panel sets.
struct LODSwitch : vtkGeometryRepresentation
{
  static bool IsSuppressed(vtkGeometryRepresentation* drawing) { return drawing->*(&LODSwitch::SuppressLOD); }
};

constexpr double MostPoints = 5e5;
constexpr double MostPointsInMotion = 2e5;

int FindStep(vtkIdType points, double most)
{
  return int(std::ceil(std::sqrt(double(points) / most)));
}

/// Calls a function for a data object, or for all blocks of it.
template <class Function>
void ForBlocks(vtkDataObject* data, const Function& function)
{
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    function(data);
    return;
  }
  const auto all = vtk::TakeSmartPointer(blocks->NewIterator());
  for (all->InitTraversal(); !all->IsDoneWithTraversal(); all->GoToNextItem())
  {
    function(all->GetCurrentDataObject());
  }
}

void AddArrays(vtkDataObject* block)
{
  const VerticalAxis axis = ReadVerticalAxis(block->GetFieldData());
  if (auto* const data = vtkDataSet::SafeDownCast(block))
  {
    AddHeightsInUnit(data, axis);
  }
  auto* const points = vtkPointSet::SafeDownCast(block);
  if (points && points->GetPoints())
  {
    AddRenamedArrays(points);
    LiftFaultLines(points);
  }
}

int CallMethod(vtkClientServerInterpreter* interpreter, vtkObjectBase* object, const char* method,
  const vtkClientServerStream& message, vtkClientServerStream& result, void*)
{
  double interval = 0.0;
  if (std::strcmp(method, "SetContourInterval") == 0 && message.GetArgument(0, 2, &interval))
  {
    static_cast<vtkHorizonRepresentation*>(object)->SetContourInterval(interval);
    return 1;
  }
  return interpreter->CallCommandFunction("vtkPVCompositeRepresentation", object, method, message, result);
}
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonHeights::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* const output = vtkDataObject::GetData(outputs);
  output->ShallowCopy(vtkDataObject::GetData(inputs[0]));
  const int step = FindStep(output->GetNumberOfElements(vtkDataObject::POINT), MostPoints);
  ForBlocks(output,
    [&](vtkDataObject* block)
    {
      auto* const horizon = vtkPolyData::SafeDownCast(block);
      if (horizon && this->DrawsSurfaces)
      {
        MakeSheet(horizon, step, this->ContourInterval);
      }
      AddArrays(block);
    });
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> vtkHorizonHeights::Thin(vtkDataObject* drawn) const
{
  const auto thin = vtk::TakeSmartPointer(drawn->NewInstance());
  thin->ShallowCopy(drawn);
  const int step = FindStep(thin->GetNumberOfElements(vtkDataObject::POINT), MostPointsInMotion);
  bool areSheets = true;
  ForBlocks(thin,
    [&](vtkDataObject* block)
    {
      auto* const sheet = vtkPolyData::SafeDownCast(block);
      areSheets = areSheets && sheet && sheet->GetPointData()->HasArray(SheetIds);
      if (areSheets && step > 1)
      {
        MakeSheet(sheet, step, this->ContourInterval);
      }
    });
  return areSheets ? thin : nullptr;
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
      interpreter->AddCommandFunction("vtkHorizonRepresentation", CallMethod);
    });
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonRepresentation::SetContourInterval(double interval)
{
  this->Heights->SetContourInterval(interval);
  this->MarkModified();
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  this->InsertHeights();
  auto* const drawing = vtkGeometryRepresentation::SafeDownCast(this->GetActiveRepresentation());
  if (drawing && request == vtkPVView::REQUEST_UPDATE())
  {
    drawing->SetArrayIdNames(SheetIds, SheetIds);
  }
  if (drawing && request == vtkPVView::REQUEST_RENDER())
  {
    DrawContours(drawing->GetActor());
  }
  if (drawing && request == vtkPVView::REQUEST_UPDATE_LOD() && !LODSwitch::IsSuppressed(drawing))
  {
    vtkDataObject* const drawn = vtkPVView::GetPiece(input, drawing);
    if (const vtkSmartPointer<vtkDataObject> thin = drawn ? this->Heights->Thin(drawn) : nullptr)
    {
      drawing->SetSuppressLOD(true); // ParaView's would merge points.
      const int isDone = this->Superclass::ProcessViewRequest(request, input, output);
      drawing->SetSuppressLOD(false);
      vtkPVView::SetPieceLOD(input, drawing, thin);
      return isDone;
    }
  }
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
  // Classes that derive from it draw outlines and glyphs.
  const std::string kind = drawing->GetClassName();
  const bool drawsSurfaces = (kind == "vtkGeometryRepresentation" || kind == "vtkGeometryRepresentationWithFaces") &&
    vtkGeometryRepresentation::SafeDownCast(drawing)->GetRepresentation() != vtkGeometryRepresentation::POINTS;
  if (drawsSurfaces != this->Heights->GetDrawsSurfaces())
  {
    this->Heights->SetDrawsSurfaces(drawsSurfaces);
    drawing->MarkModified();
  }
  // ParaView may reconnect the mapper to the pipeline.
  if (drawing->GetInputConnection(0, 0) != this->Heights->GetOutputPort())
  {
    this->Heights->SetInputConnection(drawing->GetInputConnection(0, 0));
    drawing->SetInputConnection(this->Heights->GetOutputPort());
  }
  return true;
}
