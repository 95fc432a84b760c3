// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPointWindow_h
#define SeismicHorizonsPointWindow_h

#include "Common/Base/Monitor.h"

#include <Eigen/Core>

#include <vector>

namespace SeismicHorizons
{
/// Places relative to a middle, since squares of survey coordinates lose digits.
struct PlaneCloud
{
  const std::vector<double>& X;
  const std::vector<double>& Y;
  Eigen::Vector2d Middle = Eigen::Vector2d::Zero();

  std::int64_t Size() const { return std::int64_t(this->X.size()); }
  Eigen::Vector2d operator[](std::int64_t point) const
  {
    return Eigen::Vector2d(this->X[std::size_t(point)], this->Y[std::size_t(point)]) - this->Middle;
  }
};

/// Halves the bounding box towards the half with more points until at most `mostPoints` remain. Points are distinct, by
/// ascending x and y.
std::vector<Eigen::Vector2d> CrowdedWindow(const PlaneCloud& points, std::int64_t mostPoints, const Monitor& monitor);
}

#endif
