// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightArray.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "SurveyDescription.h"
#include "SurveyFields.h"

#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
VerticalAxis ReadVerticalAxis(const ArrayTable& fieldData)
{
  const DataArray* const direction = fieldData.Find(FieldArray::VerticalDirection);
  if (!direction || direction->Type() == ValueType::Text || direction->Size() != 1)
  {
    return {};
  }
  const SurveyDescription survey = ReadSurveyFields(fieldData);
  VerticalAxis axis = NameAxis(direction->At(0), survey.VerticalUnit, survey.VerticalDomain);
  const DataArray* const toWorld = fieldData.Find(FieldArray::LatticeToWorld);
  axis.Step =
    toWorld && toWorld->Type() != ValueType::Text && toWorld->Size() == 16 ? std::fabs(toWorld->At(0, 10)) : 0.0;
  return axis;
}

//----------------------------------------------------------------------------------------------------------------------
DataArray MakeHeights(const Horizon& horizon, const VerticalAxis& axis)
{
  DataArray heights = NewArray<float>(axis.Name.c_str(), horizon.NumberOfPoints());
  heights.ComponentNames = { HeightComponent };
  float* const values = heights.As<float>();
  const double sign = axis.IsDownwards ? -1.0 : 1.0;
  constexpr std::int64_t grain = 1 << 14;
  ParallelFor(horizon.NumberOfPoints(), grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        values[n] = float(sign * horizon.Places.At(n, 2));
      }
    });
  return heights;
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveHeights(Horizon& horizon)
{
  const DataArray* const direction = horizon.FieldData.Find(FieldArray::VerticalDirection);
  const std::string name = direction ? ReadVerticalAxis(horizon.FieldData).Name : std::string();
  const DataArray* const heights = name.empty() ? nullptr : horizon.PointData.Find(name);
  if (heights && heights->ComponentNames.size() == 1 && heights->ComponentNames.front() == HeightComponent)
  {
    const bool isActive = heights->Role >= 0;
    horizon.PointData.Remove(name);
    if (isActive && horizon.PointData.Has(PointArray::VerticalIndex))
    {
      horizon.PointData.SetActiveScalars(PointArray::VerticalIndex);
    }
  }
}
}
