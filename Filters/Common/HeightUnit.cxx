// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightUnit.h"

#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
double WorldPerIndex(const Lattice& lattice)
{
  const Eigen::Vector3d up(0.0, 0.0, 1.0);
  return std::abs((lattice.ToWorld(up) - lattice.ToWorld(Eigen::Vector3d::Zero())).z());
}

//----------------------------------------------------------------------------------------------------------------------
double IndicesPerUnit(HeightUnit unit, PlanePoints columns, const std::vector<double>& height, const Lattice& lattice)
{
  if (unit == HeightUnit::World)
  {
    return 1.0 / WorldPerIndex(lattice);
  }
  if (unit == HeightUnit::Diagonal)
  {
    assert(height.size() == columns.size() && !height.empty());
    const auto ends = std::minmax_element(height.begin(), height.end());
    return LengthOfDiagonal(PlaneBox(columns), *ends.first, *ends.second);
  }
  return 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
double LengthOfDiagonal(const PlaneBox& columns, double leastHeight, double greatestHeight)
{
  return Eigen::Vector3d(double(columns.Greatest.X) - columns.Least.X, double(columns.Greatest.Y) - columns.Least.Y,
    greatestHeight - leastHeight)
    .norm();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteHeightNoise(const HeightNoise& noise, ArrayTable& figures)
{
  AddValue<double>(figures, noise.IsRounding ? FieldArray::HeightRounding : FieldArray::HeightNoise, noise.Deviation);
}
}
