// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalAxis.h"

#include "Common/Horizon/DataModel.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
VerticalAxis NameAxis(double direction, const std::string& unit, const std::string& domain)
{
  static constexpr std::array<const char*, 4> unitsOfTime = { "ms", "s", "us", "seconds" };
  const bool isTime = domain == "time" ||
    (domain.empty() && std::find(unitsOfTime.begin(), unitsOfTime.end(), unit) != unitsOfTime.end());
  VerticalAxis axis;
  axis.Unit = unit;
  axis.IsDownwards = direction < 0.0;
  // "Elevation" without unit is an array of rasters with its own colours.
  axis.Name = isTime ? "Time" : axis.IsDownwards ? "Depth" : unit.empty() ? "Height" : "Elevation";
  axis.Name += unit.empty() ? "" : " (" + unit + ")";
  return axis;
}

std::string ReadText(vtkFieldData* data, const char* name)
{
  auto* const texts = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return texts && texts->GetNumberOfValues() == 1 ? texts->GetValue(0) : std::string();
}

std::string ReadText(vtkPVDataInformation* data, const char* name)
{
  vtkPVArrayInformation* const array = data->GetArrayInformation(name, vtkDataObject::FIELD);
  return array && array->GetNumberOfStringValues() > 0 ? array->GetStringValue(0) : std::string();
}
}

//----------------------------------------------------------------------------------------------------------------------
VerticalAxis ReadVerticalAxis(vtkFieldData* data)
{
  vtkDataArray* const direction = data->GetArray(FieldArray::VerticalDirection);
  return direction && direction->GetNumberOfValues() == 1
    ? NameAxis(
        direction->GetTuple1(0), ReadText(data, FieldArray::VerticalUnit), ReadText(data, FieldArray::VerticalDomain))
    : VerticalAxis();
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
  return range[0] == range[1]
    ? NameAxis(range[0], ReadText(data, FieldArray::VerticalUnit), ReadText(data, FieldArray::VerticalDomain))
    : VerticalAxis();
}
}
