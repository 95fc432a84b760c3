// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurveyFields.h"

#include "Common/Horizon/DataModel.h"

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
void AddSurveyFields(const SurveyDescription& survey, ArrayTable& data)
{
  for (const auto& [name, text] : SurveyTexts)
  {
    if (!(survey.*text).empty())
    {
      data.Add({ name, { survey.*text } });
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
SurveyDescription ReadSurveyFields(const ArrayTable& data)
{
  SurveyDescription survey;
  for (const auto& [name, text] : SurveyTexts)
  {
    const DataArray* const array = data.Find(name);
    if (array && array->IsText() && array->Size() > 0)
    {
      survey.*text = array->Texts().front();
    }
  }
  return survey;
}
}
