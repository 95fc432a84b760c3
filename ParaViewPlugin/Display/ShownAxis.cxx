// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShownAxis.h"

#include "Common/Horizon/DataModel.h"
#include "ViewContents.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkStringArray.h"

#include <cmath>
#include <vector>

namespace SeismicHorizons
{
namespace
{
std::string ReadText(vtkFieldData* data, const char* name)
{
  auto* const texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return texts && texts->GetNumberOfValues() == 1 ? texts->GetValue(0) : std::string();
}

/// Returns false if blocks differ.
bool ReadText(vtkPVDataInformation* data, const char* name, std::string& text)
{
  vtkPVArrayInformation* const array = data->GetArrayInformation(name, vtkDataObject::FIELD);
  for (int n = 0; array && n < array->GetNumberOfStringValues(); ++n)
  {
    if (n > 0 && text != array->GetStringValue(n))
    {
      return false;
    }
    text = array->GetStringValue(n);
  }
  return true;
}
}

//----------------------------------------------------------------------------------------------------------------------
ShownArray ShowInUnit(const std::string& array, const VerticalAxis& axis)
{
  const bool isInIndices = array == PointArray::Throw;
  const bool isHeight =
    isInIndices || array == PointArray::Isochore || array == PointArray::Isopach || array == PointArray::Moved;
  if (!isHeight || axis.Unit.empty() || (isInIndices && axis.Step == 0.0))
  {
    return { array };
  }
  return { array + " (" + axis.Unit + ")", isInIndices ? axis.Step : 1.0 };
}

//----------------------------------------------------------------------------------------------------------------------
VerticalAxis ReadVerticalAxis(vtkFieldData* data)
{
  vtkDataArray* const direction = data->GetArray(FieldArray::VerticalDirection);
  if (!direction || direction->GetNumberOfValues() != 1)
  {
    return {};
  }
  VerticalAxis axis = NameAxis(
    direction->GetTuple1(0), ReadText(data, FieldArray::VerticalUnit), ReadText(data, FieldArray::VerticalDomain));
  vtkDataArray* const toWorld = data->GetArray(FieldArray::LatticeToWorld);
  axis.Step = toWorld && toWorld->GetNumberOfValues() == 16 ? std::fabs(toWorld->GetComponent(0, 10)) : 0.0;
  return axis;
}

//----------------------------------------------------------------------------------------------------------------------
VerticalAxis ReadVerticalAxis(vtkPVDataInformation* data)
{
  vtkPVArrayInformation* const direction =
    data->GetArrayInformation(FieldArray::VerticalDirection, vtkDataObject::FIELD);
  double range[2] = { 0.0, 1.0 };
  if (direction && direction->GetNumberOfComponents() == 1)
  {
    direction->GetComponentRange(0, range);
  }
  std::string unit, domain;
  if (range[0] != range[1] || !ReadText(data, FieldArray::VerticalUnit, unit) ||
    !ReadText(data, FieldArray::VerticalDomain, domain))
  {
    return {};
  }
  VerticalAxis axis = NameAxis(range[0], unit, domain);
  const std::vector<double> toWorld = ReadField(data, FieldArray::LatticeToWorld, 16);
  axis.Step = !toWorld.empty() && std::isfinite(toWorld[10]) ? std::fabs(toWorld[10]) : 0.0;
  return axis;
}
}
