// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPointWindow_h
#define SeismicHorizonsPointWindow_h

#include "Common/Monitor.h"

#include <Eigen/Core>

#include <vector>

namespace SeismicHorizons
{
/// Places in the plane as parallel arrays, and the middle they are taken relative to: coordinates of surveys are
/// millions of metres, of which squares would lose digits.
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

/// Some of the points, all that lie within a rectangle, without repetitions and by ascending x and y: the rectangle
/// around all, halved across its longer side towards the half with more points until they are few.
std::vector<Eigen::Vector2d> CrowdedWindow(const PlaneCloud& points, std::int64_t mostPoints, const Monitor& monitor);
}

#endif
