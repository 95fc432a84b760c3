// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the columns of a lattice are in the world, by least squares.

#ifndef SeismicHorizonsPlaneFit_h
#define SeismicHorizonsPlaneFit_h

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace SeismicHorizons
{
/// An affine map of the plane: place = Origin + Steps * index.
struct PlaneMap
{
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero();
  Eigen::Matrix2d Steps = Eigen::Matrix2d::Identity(); // the columns are the steps along i and along j
};

/// Sums over pairs of an index and a place. Numbers should be near 0, as with places relative to their middle: sums of
/// large squares lose digits.
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

  /// The map with the least sum of squared distances; nothing when all indices are on one line.
  std::optional<PlaneMap> Solve() const;

  /// The map for indices of which one component is the same for all: the step along the other is fitted, and that
  /// across is as long and perpendicular, so that the two are right-handed. Nothing for others.
  std::optional<PlaneMap> SolveAlongLine() const;

private:
  Eigen::Vector2d MeanIndex() const { return this->IndexSum / double(this->Count); }
  Eigen::Vector2d MeanPlace() const { return this->PlaceSum / double(this->Count); }
  /// Mean products of the differences from the means.
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
