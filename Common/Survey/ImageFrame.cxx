// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ImageFrame.h"

#include "Common/Base/Errors.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
// Largest cosine between perpendicular steps, as of rounded coordinates; it moves the last of ten thousand columns by a
// hundredth of a column.
constexpr double LargestCosine = 1e-6;

Eigen::Vector2d TurnLeft(const Eigen::Vector2d& v)
{
  return { -v.y(), v.x() };
}

ImageFrame MakeUprightFrame(const LatticeMatrix& toWorld, const std::string& kind)
{
  const Eigen::Vector2d column(toWorld[0], toWorld[4]);
  const Eigen::Vector2d row(toWorld[1], toWorld[5]);
  const double columnSize = std::hypot(column.x(), column.y());
  const double rowSize = std::hypot(row.x(), row.y());
  if (std::abs(column.dot(row)) > LargestCosine * columnSize * rowSize)
  {
    throw InputError("ColumnStep and RowStep that are not perpendicular, expected perpendicular ones for " + kind);
  }
  ImageFrame frame;
  frame.Origin = { toWorld[3], toWorld[7], toWorld[11] };
  frame.Spacing = { columnSize, rowSize, std::abs(toWorld[10]) };
  frame.Direction.topLeftCorner<2, 2>() << column / columnSize, row / rowSize;
  return frame;
}
}

//----------------------------------------------------------------------------------------------------------------------
ImageFrame MakeMapFrame(const LatticeMatrix& toWorld)
{
  ImageFrame frame = MakeUprightFrame(toWorld, "images");
  frame.Origin[2] = 0.0;
  return frame;
}

//----------------------------------------------------------------------------------------------------------------------
ImageFrame MakeVolumeFrame(const LatticeMatrix& toWorld)
{
  ImageFrame frame = MakeUprightFrame(toWorld, "volumes");
  const bool isTurned = toWorld[0] * toWorld[5] < toWorld[1] * toWorld[4]; // Clockwise from i to j, seen from above.
  frame.Direction(2, 2) = isTurned ? -1.0 : 1.0;
  frame.VerticalSign = (toWorld[10] < 0.0) == isTurned ? 1 : -1;
  return frame;
}

//----------------------------------------------------------------------------------------------------------------------
ImageFrame MakeCubeFrame(const LatticeMatrix& toWorld, const std::array<int, 2>& columns)
{
  Eigen::Matrix2d steps;
  steps << toWorld[0], toWorld[1], toWorld[4], toWorld[5];
  const Eigen::Vector2d origin(toWorld[3], toWorld[7]);
  const double side = steps.determinant() < 0.0 ? -1.0 : 1.0; // -1 if j turns right of i
  Eigen::Matrix2d axes;
  axes << steps.col(0).normalized(), steps.col(1).normalized();
  Eigen::Vector2d spacing(steps.col(0).norm(), steps.col(1).norm());
  ImageFrame frame;
  frame.Origin << origin, toWorld[11];
  if (std::abs(axes.col(0).dot(axes.col(1))) > LargestCosine)
  {
    axes.col(0) = (axes.col(0) - side * TurnLeft(axes.col(1))).normalized();
    axes.col(1) = side * TurnLeft(axes.col(0));
    spacing = (axes.transpose() * steps).diagonal();
    const Eigen::Matrix2d shear = steps - axes * spacing.asDiagonal();
    const Eigen::Vector2d half(0.5 * (columns[0] - 1), 0.5 * (columns[1] - 1));
    frame.Origin.head<2>() = origin + shear * half;
    const Eigen::Matrix2d inColumns = steps.inverse() * shear;
    frame.Deviation = std::max((inColumns * half).norm(), (inColumns * Eigen::Vector2d(half.x(), -half.y())).norm());
  }
  frame.Spacing << spacing, std::abs(toWorld[10]);
  frame.Direction.topLeftCorner<2, 2>() = axes;
  frame.Direction(2, 2) = toWorld[10] < 0.0 ? -1.0 : 1.0;
  return frame;
}
}
