// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColumnHeights.h"

#include "Common/Errors.h"

#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
PlaneBox FindBox(const std::vector<PlanePoint>& columns)
{
  if (columns.empty())
  {
    throw InputError("no points, expected a horizon");
  }
  return PlaneBox(columns);
}

std::string Describe(const PlanePoint& column)
{
  return "column (" + std::to_string(column.X) + ", " + std::to_string(column.Y) + ")";
}
}

//----------------------------------------------------------------------------------------------------------------------
ColumnHeights::ColumnHeights(const std::vector<PlanePoint>& columns, const std::vector<double>& height)
  : Links(FindBox(columns))
  , Values(std::size_t(this->Links.NumberOfColumns()), std::numeric_limits<double>::quiet_NaN())
{
  constexpr double Tolerance = 1e-3; // of whole heights, which went through world coordinates
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    double& value = this->Values[std::size_t(this->Links.ColumnOf(columns[point]))];
    if (!std::isfinite(height[point]))
    {
      throw InputError(
        "height " + std::to_string(height[point]) + " in " + Describe(columns[point]) + ", expected a finite number");
    }
    if (!std::isnan(value))
    {
      throw InputError("two points in " + Describe(columns[point]) + ", expected at most one");
    }
    value = height[point];
    this->Whole = this->Whole && std::abs(value - std::round(value)) <= Tolerance;
  }
}
}
