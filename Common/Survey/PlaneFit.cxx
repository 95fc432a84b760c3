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
Eigen::Matrix2d PlaneFit::IndexSpread() const
{
  const Eigen::Vector2d mean = this->MeanIndex();
  return this->IndexProducts / double(this->Count) - mean * mean.transpose();
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Matrix2d PlaneFit::PlaceSpread() const
{
  return this->PlaceProducts / double(this->Count) - this->MeanPlace() * this->MeanIndex().transpose();
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMap PlaneFit::MapWithSteps(const Eigen::Matrix2d& steps) const
{
  return { this->MeanPlace() - steps * this->MeanIndex(), steps };
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<PlaneMap> PlaneFit::Solve() const
{
  // Rounding of indices on a line gives about 1e-16 of the squared trace; other determinants are larger on lattices of
  // up to ten million columns per side.
  constexpr double SmallestRelativeDeterminant = 1e-14;
  if (this->Count < 3)
  {
    return std::nullopt;
  }
  const Eigen::Matrix2d spread = this->IndexSpread();
  if (!(spread.determinant() > SmallestRelativeDeterminant * spread.trace() * spread.trace()))
  {
    return std::nullopt;
  }
  return this->MapWithSteps(this->PlaceSpread() * spread.inverse());
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<PlaneMap> PlaneFit::SolveAlongLine() const
{
  constexpr double SmallestSpread = 1e-12; // Indices are integers.
  if (this->Count < 2)
  {
    return std::nullopt;
  }
  const Eigen::Matrix2d spread = this->IndexSpread();
  const bool isAlongI = spread(1, 1) < SmallestSpread;
  const int along = isAlongI ? 0 : 1;
  if (!(spread(along, along) > SmallestSpread) || spread(1 - along, 1 - along) > SmallestSpread)
  {
    return std::nullopt;
  }
  const Eigen::Vector2d step = this->PlaceSpread().col(along) / spread(along, along);
  Eigen::Matrix2d steps;
  steps.col(along) = step;
  steps.col(1 - along) = isAlongI ? Eigen::Vector2d(-step.y(), step.x()) : Eigen::Vector2d(step.y(), -step.x());
  return this->MapWithSteps(steps);
}
}
