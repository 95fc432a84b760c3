// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NodeFit.h"

#include "Common/LineErrors.h"
#include "Common/TextNumbers.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double SmallestSine = 0.01; // of the angle between the steps; surveys are nearly at right angles
constexpr double LargestShift = 0.1; // of a step; coordinates are written with few digits

Eigen::Vector2d NodeOf(const GridPoint& point)
{
  return { point.I, point.J };
}

/// By whole numbers, so that it is exact.
bool AreCollinear(const std::vector<GridPoint>& points)
{
  const auto di = [&](const GridPoint& point) { return std::int64_t(point.I) - points[0].I; };
  const auto dj = [&](const GridPoint& point) { return std::int64_t(point.J) - points[0].J; };
  const auto other =
    std::find_if(points.begin(), points.end(), [&](const auto& p) { return di(p) != 0 || dj(p) != 0; });
  return other == points.end() ||
    std::all_of(other, points.end(), [&](const auto& p) { return di(*other) * dj(p) == dj(*other) * di(p); });
}

/// Also refuses steps that are no finite numbers.
void RequireArea(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  if (!(std::fabs(i.x() * j.y() - i.y() * j.x()) > SmallestSine * i.norm() * j.norm()))
  {
    throw InputError("points on one line in the world, expected some beside it");
  }
}

void RequireOnNodes(const std::vector<GridPoint>& points, const SurveyLattice& lattice)
{
  const double step = std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm());
  for (const GridPoint& point : points)
  {
    const Eigen::Vector2d node = lattice.Origin + point.I * lattice.ColumnStep + point.J * lattice.RowStep;
    const double shift = (point.Place - node).norm();
    if (!(shift <= LargestShift * step))
    {
      throw ErrorAt(point.Line,
        "a point " + ShortestText(shift) + " from its node, expected a regular lattice with points within " +
          ShortestText(LargestShift * step));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
/// Sums are made of the distances from the mean, so that large coordinates cost no digits.
SurveyLattice FitLattice(const std::vector<GridPoint>& points, const std::array<int, 2>& columns)
{
  if (points.empty() || AreCollinear(points))
  {
    throw InputError(std::to_string(points.size()) + " points on one line of nodes, expected some beside it");
  }
  Eigen::Vector2d meanNode = Eigen::Vector2d::Zero();
  Eigen::Vector2d meanPlace = Eigen::Vector2d::Zero();
  for (const GridPoint& point : points)
  {
    meanNode += NodeOf(point) / static_cast<double>(points.size());
    meanPlace += point.Place / static_cast<double>(points.size());
  }
  Eigen::Matrix2d nodes = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d places = Eigen::Matrix2d::Zero();
  for (const GridPoint& point : points)
  {
    const Eigen::Vector2d node = NodeOf(point) - meanNode;
    nodes += node * node.transpose();
    places += (point.Place - meanPlace) * node.transpose();
  }
  const Eigen::Matrix2d steps = places * nodes.inverse();
  SurveyLattice lattice;
  lattice.Columns = columns;
  lattice.ColumnStep = steps.col(0);
  lattice.RowStep = steps.col(1);
  lattice.Origin = meanPlace - steps * meanNode;
  RequireArea(lattice);
  RequireOnNodes(points, lattice);
  return lattice;
}
}
