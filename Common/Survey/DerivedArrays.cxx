// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "DerivedArrays.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "SurveyDescription.h"
#include "SurveyFields.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
// Names the component of such arrays, as a user may have others of the same name.
constexpr const char* LineComponent = "line";

DataArray MakeHeights(const Horizon& horizon, const VerticalAxis& axis)
{
  DataArray heights = NewArray<float>(axis.Name.c_str(), horizon.NumberOfPoints());
  heights.ComponentNames = { HeightComponent };
  float* const values = heights.As<float>();
  const double sign = axis.IsDownwards ? -1.0 : 1.0;
  ParallelFor(horizon.NumberOfPoints(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        values[n] = float(sign * horizon.Places.At(n, 2));
      }
    });
  return heights;
}

/// Merged points are on no line.
DataArray NumberLines(const char* name, const DataArray& columns, int axis, double first, double step)
{
  DataArray lines = NewArray<float>(name, columns.Tuples());
  lines.ComponentNames = { LineComponent };
  float* const values = lines.As<float>();
  const int* const column = columns.As<int>() + axis;
  ParallelFor(columns.Tuples(), Grain,
    [&](std::int64_t from, std::int64_t to)
    {
      for (std::int64_t n = from; n < to; ++n)
      {
        values[n] = column[2 * n] < 0 ? std::numeric_limits<float>::quiet_NaN() : float(first + step * column[2 * n]);
      }
    });
  return lines;
}
}

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
ArrayTable MakeDerivedArrays(const Horizon& horizon)
{
  ArrayTable made;
  const VerticalAxis axis = ReadVerticalAxis(horizon.FieldData);
  if (!axis.Name.empty() && horizon.Places.Components() == 3 && !horizon.PointData.Has(axis.Name))
  {
    DataArray& heights = made.Add(MakeHeights(horizon, axis));
    const DataArray* const indices = horizon.PointData.Find(PointArray::VerticalIndex);
    heights.Role = indices ? indices->Role : -1; // What ParaView's filters make has the colours of heights.
  }
  const DataArray* const columns = horizon.PointData.Find(PointArray::Column);
  const DataArray* const numbers = horizon.FieldData.Find(FieldArray::LineNumbers);
  if (!columns || !columns->As<int>() || columns->Components() != 2 || columns->Tuples() != horizon.NumberOfPoints() ||
    !numbers || numbers->IsText() || numbers->Size() != 4)
  {
    return made;
  }
  const auto add = [&](const char* name, int side, int first)
  {
    if (!horizon.PointData.Has(name))
    {
      made.Add(NumberLines(name, *columns, side, numbers->Value(first), numbers->Value(first + 1)));
    }
  };
  add(PointArray::Inline, 1, 0);
  add(PointArray::Crossline, 0, 2);
  return made;
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveDerivedArrays(Horizon& horizon)
{
  const std::string heights = ReadVerticalAxis(horizon.FieldData).Name;
  for (const std::string& name : { heights, std::string(PointArray::Inline), std::string(PointArray::Crossline) })
  {
    const DataArray* const array = horizon.PointData.Find(name);
    if (!array || array->ComponentNames.size() != 1 ||
      array->ComponentNames.front() != (name == heights ? HeightComponent : LineComponent))
    {
      continue;
    }
    const bool isActive = array->Role >= 0;
    horizon.PointData.Remove(name);
    if (isActive && horizon.PointData.Has(PointArray::VerticalIndex))
    {
      horizon.PointData.SetActiveScalars(PointArray::VerticalIndex);
    }
  }
}
}
