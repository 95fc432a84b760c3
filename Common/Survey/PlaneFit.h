// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaneFit_h
#define SeismicHorizonsPlaneFit_h

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace SeismicHorizons
{
/// place = Origin + Steps * index; columns of Steps are the steps along i and j.
struct PlaneMap
{
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero();
  Eigen::Matrix2d Steps = Eigen::Matrix2d::Identity();
};

/// Places should be relative to their middle, since large squares lose digits.
class PlaneFit
{
public:
  void Add(const Eigen::Vector2d& index, const Eigen::Vector2d& place)
  {
    ++this->Count;
    this->IndexSum += index;
    this->PlaceSum += place;
    this->IndexProducts += index * index.transpose();
    this->PlaceProducts += place * index.transpose();
  }

  void Add(const PlaneFit& other);

  std::int64_t Size() const { return this->Count; }

  /// Returns nothing if all indices are on a line.
  std::optional<PlaneMap> Solve() const;

  /// For indices with one constant component: the other step is fitted, and the step across is as long, perpendicular
  /// and right-handed.
  std::optional<PlaneMap> SolveAlongLine() const;

private:
  Eigen::Vector2d MeanIndex() const { return this->IndexSum / double(this->Count); }
  Eigen::Vector2d MeanPlace() const { return this->PlaceSum / double(this->Count); }
  /// Covariances.
  Eigen::Matrix2d IndexSpread() const;
  Eigen::Matrix2d PlaceSpread() const;
  PlaneMap MapWithSteps(const Eigen::Matrix2d& steps) const;

  std::int64_t Count = 0;
  Eigen::Vector2d IndexSum = Eigen::Vector2d::Zero();
  Eigen::Vector2d PlaceSum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d IndexProducts = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d PlaceProducts = Eigen::Matrix2d::Zero();
};
}

#endif
