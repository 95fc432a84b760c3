// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a vertical line meets a triangle.

#ifndef SeismicHorizonsTriangleHeight_h
#define SeismicHorizonsTriangleHeight_h

#include "TriangleSurface.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
/// In plan, twice the areas that a place has with the sides across from each corner: together that of the triangle,
/// and all of its sign where the place is inside.
inline std::array<double, 3> DoubledAreas(
  const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double ax = a.x() - p.x();
  const double ay = a.y() - p.y();
  const double bx = b.x() - p.x();
  const double by = b.y() - p.y();
  const double cx = c.x() - p.x();
  const double cy = c.y() - p.y();
  return { bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx };
}

/// The z of a triangle at a place in plan; nan when the place is more than `tolerance` outside it, or when it is no
/// wider than that in plan.
inline double HeightAt(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners, double tolerance)
{
  std::array<double, 3> part = DoubledAreas(p, corners[0], corners[1], corners[2]);
  const double sum = part[0] + part[1] + part[2];
  const double turn = sum < 0.0 ? -1.0 : 1.0;
  double height = 0.0;
  double inside = 0.0;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const double square = (corners[(n + 2) % 3] - corners[(n + 1) % 3]).head<2>().squaredNorm() * tolerance * tolerance;
    if (!(sum * sum > square) || (turn * part[n] < 0.0 && part[n] * part[n] > square))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    // Just outside an edge the height is that on it.
    part[n] = std::max(0.0, turn * part[n]);
    inside += part[n];
    height += part[n] * corners[n].z();
  }
  return height / inside;
}

/// Of two heights the one nearer to a point; nan stands for none.
inline double NearerHeight(double height, double best, const Eigen::Vector3d& point)
{
  // The first comparison is false for nan.
  return std::abs(height - point.z()) >= std::abs(best - point.z()) || std::isnan(height) ? best : height;
}

/// The height of a triangle of a surface that is nearer to the point than `best`, or else that.
inline double NearerHeight(
  const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& point, double tolerance, double best)
{
  const double height = HeightAt(point, { surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]) }, tolerance);
  return NearerHeight(height, best, point);
}
}

#endif
