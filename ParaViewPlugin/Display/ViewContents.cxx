// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewContents.h"

#include "vtkDataObject.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <limits>

namespace SeismicHorizons
{
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
}
