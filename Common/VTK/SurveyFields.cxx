// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyFields.h"

#include "Common/Horizon/DataModel.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <array>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<std::pair<const char*, std::string SurveyDescription::*>, 4> SurveyTexts = {
  { { FieldArray::VerticalUnit, &SurveyDescription::VerticalUnit },
    { FieldArray::VerticalDomain, &SurveyDescription::VerticalDomain },
    { FieldArray::HorizontalUnit, &SurveyDescription::HorizontalUnit },
    { FieldArray::CoordinateSystem, &SurveyDescription::CoordinateSystem } }
};
}

//----------------------------------------------------------------------------------------------------------------------
void AddSurveyFields(const SurveyDescription& survey, vtkFieldData* data)
{
  for (const auto& [name, text] : SurveyTexts)
  {
    if (!(survey.*text).empty())
    {
      vtkNew<vtkStringArray> array;
      array->SetName(name);
      array->InsertNextValue(survey.*text);
      data->AddArray(array);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SurveyDescription ReadSurveyFields(vtkFieldData* data)
{
  SurveyDescription survey;
  for (const auto& [name, text] : SurveyTexts)
  {
    auto* const array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
    if (array && array->GetNumberOfValues() > 0)
    {
      survey.*text = array->GetValue(0);
    }
  }
  return survey;
}
}
