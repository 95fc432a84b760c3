// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFit.h"

#include <Eigen/LU>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void PlaneFit::Add(const PlaneFit& other)
{
  this->Count += other.Count;
  this->IndexSum += other.IndexSum;
  this->PlaceSum += other.PlaceSum;
  this->IndexProducts += other.IndexProducts;
  this->PlaceProducts += other.PlaceProducts;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<PlaneMap> PlaneFit::Solve() const
{
  // Where all indices are on one line the determinant is 0 but for rounding, which is some 1e-16 of the squared trace;
  // where they are not it is larger than this on any lattice of up to ten million columns along each side.
  constexpr double SmallestRelativeDeterminant = 1e-14;
  if (this->Count < 3)
  {
    return std::nullopt;
  }
  const double n = double(this->Count);
  const Eigen::Vector2d meanIndex = this->IndexSum / n;
  const Eigen::Vector2d meanPlace = this->PlaceSum / n;
  const Eigen::Matrix2d spread = this->IndexProducts / n - meanIndex * meanIndex.transpose();
  if (!(spread.determinant() > SmallestRelativeDeterminant * spread.trace() * spread.trace()))
  {
    return std::nullopt;
  }
  PlaneMap map;
  map.Steps = (this->PlaceProducts / n - meanPlace * meanIndex.transpose()) * spread.inverse();
  map.Origin = meanPlace - map.Steps * meanIndex;
  return map;
}
}
