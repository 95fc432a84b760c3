// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewContents.h"

#include "ColorRange.h"
#include "Common/Horizon/DataModel.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMInputProperty.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <limits>

namespace SeismicHorizons
{
namespace
{
/// True for points or triangles of a horizon; lines, volumes and images, which have fewer cells, cover nothing.
bool Covers(vtkPVDataInformation* data)
{
  return data->GetNumberOfPoints() > 0 && 2 * data->GetNumberOfCells() >= data->GetNumberOfPoints() &&
    data->GetArrayInformation(FieldArray::LatticeDimensions, vtkDataObject::FIELD);
}

/// True if the bounds are inside the others, or nearly.
bool IsInside(vtkPVDataInformation* data, vtkPVDataInformation* other)
{
  const double* const inner = data->GetBounds();
  const double* const outer = other->GetBounds();
  constexpr double rounding = 0.01;
  bool isInside = true;
  for (int axis = 0; axis < 6; axis += 2)
  {
    const double margin = rounding * (outer[axis + 1] - outer[axis]);
    isInside = isInside && inner[axis] >= outer[axis] - margin && inner[axis + 1] <= outer[axis + 1] + margin;
  }
  return isInside;
}

/// The first source with points or triangles that a stage is made from, or the stage itself.
vtkSMSourceProxy* FindHorizon(vtkSMSourceProxy* stage)
{
  const vtkSMPropertyHelper input(stage, "Input", true);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return source && Covers(source->GetDataInformation(input.GetOutputPort())) ? FindHorizon(source) : stage;
}

/// True if two stages have made points or triangles of one horizon, which would cover each other. Horizons of one file
/// differ in their bounds.
bool AreSiblings(vtkSMProxy* representation, vtkSMProxy* other)
{
  vtkPVDataInformation* const data = FindShownData(representation);
  vtkPVDataInformation* const shown = FindShownData(other);
  vtkSMSourceProxy* const producer = FindProducer(representation);
  return data && shown && Covers(data) && Covers(shown) &&
    shown->GetNumberOfLeaves() <= std::max<decltype(shown->GetNumberOfLeaves())>(1, data->GetNumberOfLeaves()) &&
    !LeadsTo(producer, FindProducer(other)) && !LeadsTo(FindProducer(other), producer) &&
    FindHorizon(producer) == FindHorizon(FindProducer(other)) && (IsInside(data, shown) || IsInside(shown, data));
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSMProxy*> ListRepresentations(vtkSMProxy* view)
{
  const vtkSMPropertyHelper helper(view, "Representations");
  std::vector<vtkSMProxy*> representations;
  for (unsigned int n = 0; n < helper.GetNumberOfElements(); ++n)
  {
    representations.push_back(helper.GetAsProxy(n));
  }
  return representations;
}

//----------------------------------------------------------------------------------------------------------------------
vtkPVDataInformation* FindShownData(vtkSMProxy* representation)
{
  const vtkSMPropertyHelper input(representation, "Input", true);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  const bool isShown = source && vtkSMPropertyHelper(representation, "Visibility").GetAsInt() != 0;
  return isShown ? source->GetDataInformation(input.GetOutputPort()) : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> ReadField(vtkPVDataInformation* data, const char* name, int count)
{
  vtkPVArrayInformation* const array = data->GetArrayInformation(name, vtkDataObject::FIELD);
  std::vector<double> values;
  for (int n = 0; array && array->GetNumberOfComponents() == count && n < count; ++n)
  {
    double range[2];
    array->GetComponentRange(n, range);
    values.push_back(range[0] == range[1] ? range[0] : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

//----------------------------------------------------------------------------------------------------------------------
vtkSMSourceProxy* FindProducer(vtkSMProxy* representation)
{
  return vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(representation, "Input", true).GetAsProxy());
}

//----------------------------------------------------------------------------------------------------------------------
bool LeadsTo(vtkSMProxy* source, vtkSMProxy* other)
{
  for (unsigned int n = 0; n < other->GetNumberOfProducers(); ++n)
  {
    vtkSMProxy* const input = other->GetProducerProxy(n);
    if (vtkSMInputProperty::SafeDownCast(other->GetProducerProperty(n)) && (input == source || LeadsTo(source, input)))
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkSMProxy>> HideOthers(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkSMSourceProxy* const producer = FindProducer(representation);
  const int port = static_cast<int>(vtkSMPropertyHelper(representation, "Input", true).GetOutputPort());
  bool hidesInputs = false, hidesOutputs = false;
  for (vtkPVXMLElement* const hint : producer ? ListHints(producer, port) : std::vector<vtkPVXMLElement*>())
  {
    hidesInputs = hidesInputs || hint->GetAttribute("hides_inputs");
    hidesOutputs = hidesOutputs || hint->GetAttribute("hides_outputs");
  }
  std::vector<vtkSmartPointer<vtkSMProxy>> hidden;
  for (vtkSMProxy* const other : ListRepresentations(view))
  {
    const bool isSame = FindProducer(other) == producer;
    if (FindShownData(other) && other != representation &&
      (isSame ? hidesOutputs && FindShownData(representation)->GetNumberOfPoints() > 0
              : (hidesInputs && LeadsTo(FindProducer(other), producer)) || AreSiblings(representation, other)))
    {
      vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
      controller->Hide(other, vtkSMViewProxy::SafeDownCast(view));
      hidden.emplace_back(other);
    }
  }
  return hidden;
}
}
